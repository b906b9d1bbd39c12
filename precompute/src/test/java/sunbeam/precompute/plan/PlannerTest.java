package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.setting.Choices.Origin;
import sunbeam.precompute.setting.SettingException;

class PlannerTest {
    private static final double PITCH = 50e-9;
    private static final long MUCH_MEMORY = 64L << 30;
    private static final VisibleRange MAP = VisibleRange.of(new Direction(0, 0, 1));
    private static final CieTable CIE = CieTable.load();
    private static final Request STANDARD =
            new Request(TableChoices.within(ErrorBudget.STANDARD), GaussianArea.STANDARD);
    private static final Request THESIS = new Request(TableChoices.THESIS, GaussianArea.THESIS);

    /** Fixed parts of a plan. */
    private record Request(TableChoices table, GaussianArea area) {}

    @Test
    void ordersThatTheWindowResolvesAreLookedAtOneByOne() {
        // 3.2 um under a window of 65 um: 0.03 bins.
        SpectrumPlan plan = plan(400e-9, request(65e-6));

        assertThat(((OrderSampling) plan.sampling()).resolved()).isPresent();
    }

    @Test
    void ordersThatTheWindowBlursAreResampled() {
        // 3.2 um under a window of 3.2 um: 0.64 bins, as measured skins under sunlight.
        SpectrumPlan plan = plan(400e-9, request(3.2e-6));

        assertThat(plan.sampling()).isInstanceOf(GridSampling.class);
    }

    @Test
    void ordersThatTheWindowNeitherResolvesNorBlursAreSummed() {
        // 3.2 um under a window of 10 um: 0.2 bins.
        SpectrumPlan plan = plan(400e-9, request(10e-6));

        OrderSampling orders = (OrderSampling) plan.sampling();
        assertThat(orders.resolved()).isEmpty();
        assertThat(orders.neighborhood().radiusX()).isPositive();
    }

    @Test
    void theThesisStaysAsItIs() {
        SpectrumPlan plan = plan(400e-9, THESIS);

        BinSampling bins = (BinSampling) plan.sampling();
        assertThat(bins.neighborhood()).isEqualTo(new Neighborhood(1, Neighborhood.Anchor.FLOOR));
        assertThat(bins.wavelengths().count())
                .as("380..780 nm in steps of 5 nm")
                .isEqualTo(81);
        assertThat(plan.expansion().terms()).isEqualTo(37);
        assertThat(plan.expansion().kind()).isEqualTo(Expansion.Kind.TAYLOR);
    }

    @Test
    void aWindowNeedsSamples() {
        assertThatThrownBy(() -> plan(400e-9, request(120e-9)))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("coherence length 120 nm")
                .hasMessageContaining("give 200 nm or more");
    }

    @Test
    void taylorIsRefusedWhereItCancelsInFloat32() {
        Optional<Expansion.Kind> taylor = Optional.of(Expansion.Kind.TAYLOR);

        assertThat(plan(250e-9, request(taylor, 0, 65e-6, 0)).expansion().terms())
                .as("16 for the blaze at 1e-3; here the share of the expansion is 2e-5")
                .isBetween(16, 24);
        assertThatThrownBy(() -> plan(2e-6, request(taylor, 0, 65e-6, 0)))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("taylor reaches only")
                .hasMessageContaining("use lowrank");
        assertThatThrownBy(() -> plan(5e-6, request(taylor, 37, 65e-6, 0)))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("taylor with 37 terms leaves the range of float32");
    }

    @ParameterizedTest
    @ValueSource(longs = {32L << 20, 8L << 20})
    void plansBeyondTheMemoryAreRefusedWithTheirNeed(long heap) {
        HeightMap map = Surfaces.random(1024, 1024, PITCH, 800e-9, 1);
        Planner planner = new Planner(HeightLevels.of(map), CIE, heap);

        assertThatThrownBy(() -> planner.plan(STANDARD.table(), STANDARD.area(), VisibleRange.all()))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("coherence length 65 um and")
                .hasMessageContaining("MB of memory, but Java's heap may take " + Math.round(heap * 1e-6) + " MB")
                .hasMessageContaining("SUNBEAM_JAVA_OPTIONS=-Xmx");
    }

    @Test
    void aPlannedPlanBreaksNoPromise() {
        for (double coherenceLength : new double[] {1e-6, 3.2e-6, 10e-6, 65e-6, 1e-3}) {
            assertThat(warnings(request(coherenceLength)))
                    .as("coherence length %s", coherenceLength)
                    .isEmpty();
        }
        assertThat(warnings(THESIS)).isEmpty();
    }

    @Test
    void warningsNameBrokenTolerances() {
        assertThat(warnings(request(Optional.empty(), 2, 3.2e-6, 0)))
                .singleElement()
                .asString()
                .contains("2 lowrank terms leave an error of", "more than the tolerance 0.001");
        assertThat(warnings(request(Optional.empty(), 0, 65e-6, 5e-9)))
                .singleElement()
                .asString()
                .contains("keep no tolerance; leave out wavelength step");
    }

    @Test
    void tolerancesBelowFloat32sPercentileHaveAShortfall() {
        Request ordinary = request(65e-6);
        assertThat(warnings(withTolerance(ordinary, 1e-5)))
                .anySatisfy(line -> assertThat(line)
                        .contains("tolerance 1e-5 in the median", "4.2e-5 at the 95th percentile", "method reference"));
        assertThat(warnings(withTolerance(ordinary, 2e-5)))
                .singleElement()
                .asString()
                .contains("colors on flanks of orders");
        assertThat(warnings(withTolerance(ordinary, 4e-5))).isEmpty();
    }

    @Test
    void windowsTooWideForFloat32HaveAShortfall() {
        Request wide = request(1e-3);
        assertThat(warnings(withTolerance(wide, 1e-4)))
                .singleElement()
                .asString()
                .contains("colors on flanks of orders", "1 mm");
        assertThat(warnings(withTolerance(wide, 1e-3))).isEmpty();
    }

    private static Request withTolerance(Request request, double tolerance) {
        return new Request(TableChoices.within(tolerance), request.area());
    }

    private static SpectrumPlan plan(double relief, Request request) {
        return planner(relief).plan(request.table(), request.area(), MAP);
    }

    private static List<String> warnings(Request request) {
        return plan(400e-9, request).warnings().stream()
                .map(line -> line.in(Origin.PROGRAM))
                .toList();
    }

    /** Of a sine on 3.2 um. */
    private static Planner planner(double relief) {
        return planner(Surfaces.of(
                64, 64, PITCH, (x, y) -> relief / 2 * Math.sin(2 * Math.PI * (3 * x + y) / (64 * PITCH))));
    }

    private static Planner planner(HeightMap map) {
        return new Planner(HeightLevels.of(map), CIE, MUCH_MEMORY);
    }

    @Test
    void moreStepsThanDriversTakeAreRefusedBeforeAnythingIsComputed() {
        Request asked = request(Optional.empty(), 0, 1e-6, 0.05e-9);

        assertThatThrownBy(() -> planner(400e-9).plan(asked.table(), asked.area(), VisibleRange.all()))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("steps a pixel")
                .hasMessageContaining("more than 60,000");
        // Shaders do not sum colors along rays.
        Planner ofTables = planner(400e-9).ofTables(Average.ENSEMBLE);
        SpectrumPlan plan = ofTables.plan(asked.table(), asked.area().with(Average.ENSEMBLE), VisibleRange.all());
        assertThat(plan.sampling().loopSteps(plan)).isGreaterThan(PlanChecks.MOST_LOOP_STEPS);
        Planner ofShaders = planner(400e-9);
        assertThat(ofShaders.ofTables(Average.COHERENT)).isSameAs(ofShaders);
    }

    @Test
    void aPatchThatIsShortAlongOneAxisHasFewBinsThere() {
        HeightMap line = Surfaces.random(64, 1, 50e-9, 400e-9, 5);
        GaussianArea area = GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(5e-6));

        SpectrumPlan plan = planner(line).plan(STANDARD.table(), area, VisibleRange.all());

        Neighborhood bins = ((OrderSampling) plan.sampling()).neighborhood();
        // The next order along y lies far beyond the window's spectrum.
        assertThat(bins.radiusY()).isZero();
        assertThat(bins.radiusX()).isPositive();
    }

    @ParameterizedTest
    @CsvSource({"156e-6, 65e-6", "156e-6, 140e-6", "369e-6, 65e-6", "369e-6, 140e-6"})
    void aLineOfManySamplesIsSummedUnderLongWindowsToo(double width, double coherenceLength) {
        HeightMap line = Surfaces.random(8192, 1, width / 8192, 400e-9, 5);
        GaussianArea area = GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(coherenceLength));

        SpectrumPlan plan = planner(line).plan(STANDARD.table(), area, VisibleRange.all());

        assertThat(plan.sampling()).isInstanceOf(OrderSampling.class);
    }

    @Test
    void reliefsBeyondAnyExpansionAreRefused() {
        HeightMap tall = Surfaces.random(32, 32, 1e-6, 100e-6, 5);

        assertThatThrownBy(() -> planner(tall).plan(STANDARD.table(), GaussianArea.STANDARD, VisibleRange.all()))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("rad, more than 800; method reference");
    }

    private static Request request(double coherenceLength) {
        return request(Optional.empty(), 0, coherenceLength, 0);
    }

    /** Zero or empty where the planner chooses. */
    private static Request request(
            Optional<Expansion.Kind> expansion, int terms, double coherenceLength, double wavelengthStep) {
        TableChoices table = new TableChoices(
                Optional.of(ErrorBudget.STANDARD),
                expansion,
                terms == 0 ? Optional.empty() : Optional.of(terms),
                Optional.empty(),
                wavelengthStep == 0 ? Optional.empty() : Optional.of(wavelengthStep));
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        return new Request(table, GaussianArea.STANDARD.with(window));
    }
}
