package sunbeam.precompute.method;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.FRESNEL;
import static sunbeam.precompute.plan.MethodSettings.INTERPOLATION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.REPLICAS;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.LevelBakers.Lazy;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings.GemForm;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Neighborhood;
import sunbeam.precompute.plan.Neighborhood.Anchor;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.spectrum.PeriodInterpolation;

/** Choices to methods: settings without a meaning for the method are refused. */
class MethodsTest {
    private static final Choices PQ = Choices.none().with(Methods.METHOD, PqMethod.TYPE);
    private static final Choices GEM = Choices.none().with(Methods.METHOD, GemMethod.TYPE);
    private static final Choices REFERENCE = Choices.none().with(Methods.METHOD, ReferenceMethod.TYPE);
    private static final Choices THESIS = Choices.none().with(PRESET, Preset.THESIS);

    @ParameterizedTest
    @FieldSource("sunbeam.precompute.method.Methods#ALL")
    void eachTypeMakesItsOwnMethodFromSettingsThatAreDeclared(MethodType type) {
        assertThat(Methods.of(Choices.none().with(Methods.METHOD, type)).type()).isSameAs(type);
        assertThat(Methods.SETTINGS).containsAll(type.settings()).doesNotHaveDuplicates();
        assertThat(Methods.METHOD.kind().parse(type.label())).isSameAs(type);
    }

    @Test
    void thesisPresetAppliesToEachMethodUnderTheChoices() {
        PqMethod pq = (PqMethod) Methods.of(PQ.over(THESIS));
        assertThat(pq.interpolation()).isEqualTo(PeriodInterpolation.RING);
        assertThat(pq.fresnel()).isEqualTo(FresnelFactor.SQUARED);
        GemMethod gem = (GemMethod) Methods.of(GEM.over(THESIS));
        assertThat(gem.form()).isEqualTo(GemForm.THESIS);
        assertThat(((GemMethod) Methods.of(GEM)).form()).isEqualTo(GemForm.STAM);

        Choices once = THESIS.with(FRESNEL, FresnelFactor.ONCE);
        FullMethod full = (FullMethod) Methods.of(once);
        assertThat(full.fresnel()).isEqualTo(FresnelFactor.ONCE);
        assertThat(full.table()).isEqualTo(FullMethod.thesis().table());
        PqMethod sinc = (PqMethod) Methods.of(PQ.over(THESIS).with(INTERPOLATION, PeriodInterpolation.SINC));
        assertThat(sinc.interpolation()).isEqualTo(PeriodInterpolation.SINC);
    }

    @Test
    void binsAreTheThesisS() {
        Choices anchor = Choices.none().with(ANCHOR, Anchor.NEAREST);
        assertThatThrownBy(() -> Methods.of(anchor)).hasMessageStartingWith("anchor nearest is of the thesis's bins");
        FullMethod method = (FullMethod) Methods.of(anchor.over(THESIS));
        assertThat(method.table().neighborhood()).contains(new Neighborhood(1, Anchor.NEAREST));
        FullMethod wide = (FullMethod) Methods.of(THESIS.with(RADIUS, 3));
        assertThat(wide.table().neighborhood()).contains(new Neighborhood(3, Anchor.FLOOR));
    }

    @Test
    void replicasOfTheReferenceStandInPlaceOfTheWindow() {
        ReferenceMethod method = (ReferenceMethod) Methods.of(REFERENCE.with(REPLICAS, 3));
        assertThat(method.replicas()).contains(new Replicas(3, 3));
        assertThatThrownBy(() -> Methods.of(REFERENCE.with(REPLICAS, 3).with(WINDOW_ORIGIN, WindowOrigin.CENTRE)))
                .hasMessageStartingWith("window origin centre belongs to the Gaussian window, which replicas");
        assertThatThrownBy(() -> Methods.of(REFERENCE.with(REPLICAS, 3).with(AVERAGE, Average.ENSEMBLE)))
                .hasMessageStartingWith("average ensemble is not for replicas");
    }

    private final CieTable cie = CieTable.load();

    @Test
    void aNarrowOrderHasTheWidthOfItsGaussianInWavelength() {
        double wavelength = 550.5e-9;
        double width = 1e3;
        double[] weight = NmmMethod.weight(cie, 1 / wavelength, width);
        double expected =
                Math.sqrt(Math.PI) * wavelength * wavelength * width * cie.at(wavelength, 1) / cie.integralOfY();
        // 0.3 nm wide: S ybar is a straight line there, and lambda^2 bends by 1e-6.
        assertThat(weight[1]).isCloseTo(expected, within(1e-5 * expected));
    }

    @Test
    void ordersThatTileTheBandAddUpToWhite() {
        double[] sum = new double[3];
        double width = 2e4;
        double step = width / 2;
        for (double place = 1e6; place < 3e6; place += step) {
            double[] piece = NmmMethod.weight(cie, place, width);
            for (int c = 0; c < 3; c++) {
                sum[c] += piece[c] * step / (Math.sqrt(Math.PI) * width);
            }
        }
        // Gaussians half a width apart add up to 1 within 2 exp(-(pi / 0.5)^2) = 1e-17; the rest is that a quarter of a
        // width, 1 to 3 nm, steps across the corners of the 1 nm table.
        assertThat(sum[1]).isCloseTo(1, within(1e-3));
    }

    private static final TableMethod METHOD = new TableMethod(1e-2, GaussianArea.STANDARD);

    private static String key(List<DirectionPair> pairs) {
        HeightMap map = BuiltInPatches.generate("blaze");
        Surface surface = new Surface(map, "blaze", CieTable.load());
        return METHOD.plan(surface, VisibleRange.of(pairs)).key(MethodUse.COLOR);
    }

    private static List<DirectionPair> pairs(double middle) {
        Direction light = new Direction(0, 0, 1);
        Stream<Direction> border = DoubleStream.of(0, 90, 180, 270).mapToObj(phi -> Direction.ofDegrees(40, phi));
        return Stream.concat(border, Stream.of(Direction.ofDegrees(middle, 200)))
                .map(viewer -> new DirectionPair(light, viewer))
                .toList();
    }

    /** Both use texels of the coarsest table, but refined tables contain only one list's tiles. */
    @Test
    void listsThatDifferByLessThanATexelHaveTablesOfTheirOwn() {
        assertThat(key(pairs(20))).isEqualTo(key(pairs(20))).isNotEqualTo(key(pairs(20.001)));
    }

    private static double steps(double relief) {
        HeightMap map = Surfaces.random(128, 128, 0.5e-6, relief, 1);
        MethodPlan plan = FullMethod.of(Choices.none())
                .plan(new Surface(map, "deep", CieTable.load()), VisibleRange.of(pairs(20)));
        Matcher steps = Pattern.compile("up to ([0-9,]+) steps a pixel").matcher(plan.summary());
        assertThat(steps.find()).as(plan.summary()).isTrue();
        return Double.parseDouble(steps.group(1).replace(",", ""));
    }

    /** Terms grow with the relief, but for some ten of them; wavelengths do where interference decides their number. */
    @Test
    void aPlanSaysTheWorkOfADeepRelief() {
        assertThat(steps(8e-6) / steps(4e-6)).isBetween(1.5, 4.1);
    }

    private final AtomicInteger made = new AtomicInteger();

    @Test
    void threadsThatNeedAValueAtOnceShareIt() {
        CompletableFuture<Void> begun = new CompletableFuture<>();
        CompletableFuture<Void> goOn = new CompletableFuture<>();
        Lazy<Integer> lazy = new Lazy<>(() -> {
            begun.complete(null);
            goOn.join();
            return made.incrementAndGet();
        });
        CompletableFuture<Integer> first = CompletableFuture.supplyAsync(lazy::get);
        begun.join();
        CompletableFuture<Integer> second = CompletableFuture.supplyAsync(lazy::get);
        goOn.complete(null);
        assertThat(first.join()).isOne();
        assertThat(second.join()).isOne();
    }

    @Test
    void afterAFailureTheNextTriesAgain() {
        Lazy<Integer> lazy = new Lazy<>(() -> {
            if (made.incrementAndGet() == 1) {
                throw new OutOfMemoryError("no room");
            }
            return made.get();
        });
        assertThatThrownBy(lazy::get).isInstanceOf(OutOfMemoryError.class);
        assertThat(lazy.get()).isEqualTo(2);
        assertThat(lazy.get()).isEqualTo(2);
    }
}
