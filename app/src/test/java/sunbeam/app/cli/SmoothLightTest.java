package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.cli.Certificate.Limits;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.CieTable.Observer;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight.Quadrature;
import sunbeam.precompute.setting.Choices;

/** Claim of {@link Illuminant#isSmooth}: the wavelengths of method full, at equal steps where orders are wide, resolve the light. */
@NeedsDisplay
class SmoothLightTest extends CommandLineFixture {
    private static final double TOLERANCE = 1e-3;
    private static final int PAIRS = 12;

    private DiffractionSetup rough;

    @BeforeEach
    void makeARoughSurface() throws IOException {
        rough = new MethodProbe(folder, rough(32)).setup();
    }

    @ParameterizedTest
    @ValueSource(strings = {"D65", "LED-B3"})
    void smoothLightsKeepTheTolerance(String name) {
        CieTable light = CieTable.of(Observer.CIE1931, Illuminant.of(name));
        assertThat(light.isSmooth()).isTrue();
        ErrorStatistics errors = errors(light);
        assertThat(Limits.of(TOLERANCE).hold(errors)).as("%s", errors).isTrue();
    }

    /** Peaks less than 7 nm wide at half maximum in the blue, 10 nm in the green, are not smooth. */
    @ParameterizedTest
    @ValueSource(doubles = {450, 550})
    void aPeakAsWideAsTheLimitKeepsTheToleranceAndANarrowOneWouldNot(double peak) {
        CieTable wide = led(peak, peak < 500 ? 3.1 : 4.3);
        assertThat(wide.isSmooth()).isTrue();
        assertThat(Limits.of(TOLERANCE).hold(errors(wide)))
                .as("%s", errors(wide))
                .isTrue();

        assertThat(led(peak, peak < 500 ? 2.7 : 3.9).isSmooth()).isFalse();
        CieTable narrow = led(peak, peak < 500 ? 1 : 2);
        assertThat(Limits.of(TOLERANCE).hold(errors(narrow))).as("as lines").isTrue();
        CieTable tampered = new CieTable(narrow.weighted(), narrow.integralOfY(), "tampered", true);
        assertThat(Limits.of(TOLERANCE).hold(errors(tampered)))
                .as("%s", errors(tampered))
                .isFalse();
    }

    private static CieTable led(double peak, double deviation) {
        double[] power = IntStream.rangeClosed(380, 780)
                .mapToDouble(nm -> Math.exp(-0.5 * Math.pow((nm - peak) / deviation, 2)))
                .toArray();
        return CieTable.of(Observer.CIE1931, new Illuminant("LED", power));
    }

    private ErrorStatistics errors(CieTable light) {
        DiffractionSetup setup = rough.withLight(light);
        Choices choices = Choices.none()
                .with(MethodSettings.AVERAGE, Average.ENSEMBLE)
                .with(MethodSettings.COHERENCE_LENGTH, 2e-6)
                .with(MethodSettings.TOLERANCE, TOLERANCE);
        Method method = Methods.of(choices);
        SplittableRandom random = new SplittableRandom(1);
        List<DirectionPair> pairs = IntStream.range(0, PAIRS)
                .mapToObj(i -> new DirectionPair(
                        Direction.ofDegrees(20, 10),
                        Direction.ofDegrees(60 * random.nextDouble(), 360 * random.nextDouble())))
                .toList();
        List<float[]> drawn = MethodProbe.evaluate(
                pairs.stream().map(pair -> new DirectionQuery(pair, 0)).toList(),
                setup.tables(method.plan(setup.surface(), VisibleRange.of(pairs)), MethodUse.COLOR),
                false);
        return Comparison.relative(IntStream.range(0, PAIRS)
                .mapToObj(i -> new Comparison(
                        new double[] {drawn.get(i)[0], drawn.get(i)[1], drawn.get(i)[2]},
                        setup.exact(method).xyz(pairs.get(i), Quadrature.EXACT),
                        1))
                .toList());
    }
}
