package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.GridSampling.TermsLayout;
import sunbeam.precompute.plan.Sampling.BinSampling;
import sunbeam.precompute.plan.Sampling.OrderSampling;
import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.FourierTable;

/** Plans, their refusals and warnings, and the tables that they lead to. */
class PlannerTest {
    private static final double PITCH = 50e-9;
    private static final long MUCH_MEMORY = 64L << 30;
    private static final VisibleRange MAP = VisibleRange.of(new Direction(0, 0, 1));
    private static final CieTable CIE = CieTable.load();
    private static final Choices STANDARD = Choices.none();
    private static final Choices THESIS = STANDARD.with(PRESET, Preset.THESIS);
    private static final Choices TAYLOR = STANDARD.with(EXPANSION, Expansion.Kind.TAYLOR);

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
        assertThat(plan.warnings()).isEmpty();
    }

    @Test
    void aWindowNeedsSamples() {
        Choices shortest = STANDARD.with(COHERENCE_LENGTH, 120e-9);
        assertRefused(planner(400e-9), shortest, "coherence length 120 nm", "give 200 nm or more");
        // Samples so far apart show no structure.
        HeightMap wide = new HeightMap(16, 16, 78e-6, 78e-6, new double[256]);
        assertRefused(planner(wide, MUCH_MEMORY), STANDARD, "check the scan's size and its unit");
    }

    @Test
    void taylorIsRefusedWhereItCancelsInFloat32() {
        assertThat(plan(250e-9, TAYLOR).expansion().terms())
                .as("16 for the blaze at 1e-3; here the share of the expansion is 2e-5")
                .isBetween(16, 24);
        assertRefused(planner(2e-6), TAYLOR, "taylor reaches only", "use lowrank");
        assertRefused(planner(5e-6), TAYLOR.with(TERMS, 37), "taylor with 37 terms leaves the range of float32");
    }

    @ParameterizedTest
    @ValueSource(longs = {32L << 20, 8L << 20})
    void plansBeyondTheMemoryAreRefusedWithTheirNeed(long heap) {
        HeightMap map = Surfaces.random(1024, 1024, PITCH, 800e-9, 1);
        String limit = "MB of memory, but Java's heap may take " + Math.round(heap * 1e-6) + " MB";
        assertRefused(planner(map, heap), STANDARD, "coherence length 65 um and", limit);
    }

    @Test
    void warningsNameBrokenTolerances() {
        assertThat(warnings(STANDARD.with(TERMS, 2)))
                .singleElement()
                .asString()
                .contains("2 lowrank terms leave an error of", "more than the tolerance 0.001");
        assertThat(warnings(STANDARD.with(WAVELENGTH_STEP, 5e-9)))
                .singleElement()
                .asString()
                .contains("keep no tolerance; leave out wavelength step");
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '"',
            value = {
                "65e-6, 1e-5, tolerance 1e-5 in the median, 4.2e-5 at the 95th percentile",
                "65e-6, 2e-5, colors on flanks of orders, 65 um",
                "65e-6, 4e-5, ,",
                "1e-3, 1e-4, colors on flanks of orders, 1 mm",
                "1e-3, 1e-3, ,",
                "65e-6, 1e-3, ,",
                "10e-6, 1e-3, ,",
                "3.2e-6, 1e-3, ,",
                "1e-6, 1e-3, ,"
            })
    void tolerancesBeyondFloat32HaveAShortfall(double coherenceLength, double tolerance, String reason, String value) {
        List<String> lines = warnings(STANDARD.with(TOLERANCE, tolerance).with(COHERENCE_LENGTH, coherenceLength));
        if (reason == null) {
            assertThat(lines).isEmpty();
        } else {
            assertThat(lines).anySatisfy(line -> assertThat(line).contains(reason, value));
        }
    }

    @Test
    void oneTextureMayTakeLessThanAllTogether() {
        // 1.44 GB each: together less than 3 GB, and each less than the 1.5 GiB that Mesa gives to one.
        ArrayLayout half = ArrayLayout.layered("half", 15_000, 1_500, 4, 4);
        assertThat(new MemoryNeed(0, List.of(half, half)).excess(MUCH_MEMORY)).isEmpty();
        ArrayLayout whole = ArrayLayout.layered("whole", 15_000, 1_500, 8, 4);
        assertThat(new MemoryNeed(0, List.of(whole)).excess(MUCH_MEMORY))
                .hasValueSatisfying(excess -> assertThat(excess.words()).contains("a texture of 2.9 GB", "1.6 GB"));
    }

    private static SpectrumPlan plan(double relief, Choices choices) {
        return plan(planner(relief), choices, MAP);
    }

    private static SpectrumPlan plan(Planner planner, Choices choices, VisibleRange range) {
        return planner.plan(new TableChoices(choices), GaussianArea.of(choices), range);
    }

    private static void assertRefused(Planner planner, Choices choices, String... words) {
        assertThatThrownBy(() -> plan(planner, choices, VisibleRange.all()))
                .isInstanceOf(SettingException.class)
                .hasMessageContainingAll(words);
    }

    private static List<String> warnings(Choices choices) {
        return plan(400e-9, choices).warnings().stream()
                .map(line -> line.in(ChoiceOrigin.PROGRAM))
                .toList();
    }

    /** Of a sine on 3.2 um. */
    private static Planner planner(double relief) {
        return planner(
                Surfaces.of(64, 64, PITCH, (x, y) -> relief / 2 * Math.sin(2 * Math.PI * (3 * x + y) / (64 * PITCH))),
                MUCH_MEMORY);
    }

    private static Planner planner(HeightMap map, long heap) {
        return new Planner(map, CIE, heap, Sampling.MOST_LOOP_STEPS, Roughness.Cache.NONE);
    }

    @Test
    void moreStepsThanDriversTakeAreRefusedBeforeAnythingIsComputed() {
        Choices many = STANDARD.with(COHERENCE_LENGTH, 1e-6).with(WAVELENGTH_STEP, 0.05e-9);
        assertRefused(planner(400e-9), many, "steps a pixel", "more than 60,000");
        // Shaders do not sum colors along rays.
        Planner ofTables = planner(400e-9).ofTables(Average.ENSEMBLE);
        SpectrumPlan plan = plan(ofTables, many.with(AVERAGE, Average.ENSEMBLE), VisibleRange.all());
        assertThat(plan.sampling().loopSteps(plan)).isGreaterThan(Sampling.MOST_LOOP_STEPS);
        assertRefused(planner(400e-9).ofTables(Average.COHERENT), many, "steps a pixel");
    }

    @ParameterizedTest
    @CsvSource({"156e-6, 65e-6", "156e-6, 140e-6", "369e-6, 65e-6", "369e-6, 140e-6"})
    void aLineOfManySamplesIsSummedUnderLongWindowsToo(double width, double coherenceLength) {
        HeightMap line = Surfaces.random(8192, 1, width / 8192, 400e-9, 5);
        Choices choices = STANDARD.with(COHERENCE_LENGTH, coherenceLength);
        assertThat(plan(planner(line, MUCH_MEMORY), choices, VisibleRange.all()).sampling())
                .isInstanceOf(OrderSampling.class);
    }

    @Test
    void reliefsBeyondAnyExpansionAreRefused() {
        HeightMap tall = Surfaces.random(32, 32, 1e-6, 100e-6, 5);
        assertRefused(planner(tall, MUCH_MEMORY), STANDARD, "rad, more than 800; method reference");
    }

    private static final int SIDE = 64;
    private static final double WIDTH = 12e-6;
    private final SplittableRandom random = new SplittableRandom(8);

    @Test
    void roughSurfacesAreMeasuredInAllDirections() {
        Roughness roughness = measured(sample -> random.nextGaussian(), WIDTH);
        assertTrue(roughness.isRough() && !roughness.areOrdersIsolated());
        // White noise of a phase of radians scatters everywhere; grazing directions, with small w, leave more in the
        // mirror direction.
        assertTrue(roughness.bright() > 0.95 && roughness.diffracted() > 0.2, roughness.toString());
        assertTrue(roughness.dark() < roughness.mean());
    }

    @Test
    void betweenTheOrdersOfAGratingItIsDark() {
        Roughness grating = measured(sample -> Math.sin(2 * Math.PI * (sample % SIDE) * WIDTH / SIDE / 1e-6), WIDTH);
        assertTrue(grating.areOrdersIsolated() && !grating.isRough(), grating.toString());
    }

    @Test
    void windowsOfFewDeviationsHaveNoRoughness() {
        assertEquals(Roughness.NONE, measured(sample -> random.nextGaussian(), WIDTH / 4));
        assertFalse(Roughness.NONE.isRough());
    }

    private static Roughness measured(IntToDoubleFunction shape, double coherenceLength) {
        return Roughness.measure(
                Surfaces.sampled(SIDE, SIDE, WIDTH / SIDE, (x, y) -> 100e-9 * shape.applyAsDouble(y * SIDE + x)),
                CoherenceWindow.ofCoherenceLength(coherenceLength),
                WindowOrigin.CENTRE,
                VisibleRange.all(),
                Roughness.Cache.NONE);
    }

    private static final HeightMap SKIN = Surfaces.random(64, 64, 50e-9, 400e-9, 5);

    /** Coherence lengths that lead to each kind of sampling, and the thesis's. */
    @ParameterizedTest
    @CsvSource({
        "OrderSampling, NONE, 65e-6",
        "OrderSampling, NONE, 10e-6",
        "GridSampling, NONE, 3.2e-6",
        "BinSampling, THESIS, 3.2e-6"
    })
    void tablesHaveTheShapesThatWerePlannedAndTakeNoMore(String form, Preset preset, double coherenceLength) {
        SpectrumPlan plan = plan(preset, coherenceLength, Average.COHERENT);
        assertThat(plan.sampling().getClass().getSimpleName()).isEqualTo(form);
        SpectrumPlan ensemble = plan(preset, coherenceLength, Average.ENSEMBLE);
        long most = MemoryNeed.of(ensemble, SKIN.rows()).textureBytes();
        for (MethodUse use : MethodUse.values()) {
            ShaderTables tables = tables(plan, use);
            // The number of an ensemble's terms is an estimate.
            List<ArrayLayout> planned = plan.layouts(use).stream()
                    .filter(layout -> !layout.sampler().startsWith("ensemble"))
                    .toList();
            assertThat(tables.arrays())
                    .extracting(TableArray::layout)
                    .filteredOn(layout -> !layout.sampler().startsWith("ensemble"))
                    .containsExactlyInAnyOrderElementsOf(planned);
            for (TableArray array : tables.arrays()) {
                int last = array.layout().layers() - 1;
                assertThat(array.layer(last).remaining())
                        .isEqualTo(array.layout().floatsPerLayer());
            }
            assertThat(tables(ensemble, use).bytes()).isLessThanOrEqualTo(most);
        }
    }

    private static SpectrumPlan plan(Preset preset, double coherenceLength, Average average) {
        Choices choices = Choices.none()
                .with(PRESET, preset)
                .with(COHERENCE_LENGTH, coherenceLength)
                .with(AVERAGE, average);
        return plan(planner(SKIN, MUCH_MEMORY), choices, MAP);
    }

    private static ShaderTables tables(SpectrumPlan plan, MethodUse use) {
        FourierTable table = plan.fourierTable(SKIN, done -> {});
        return plan.tables(table, use, CIE);
    }

    /** The last, a grid that is itself too long, is left to the plan. */
    @ParameterizedTest
    @CsvSource({"1402, 900, 3, 4206, 2", "20000, 1, 3, 20000, 6"})
    void texelsOfOnePlaceLieSideBySide(int samples, int rows, int texels, int width, int layers) {
        TermsLayout layout = TermsLayout.of("rays", samples, rows, texels, 2);
        assertEquals(ArrayLayout.layered("rays", width, rows, layers, 4), layout.array());
    }

    @ParameterizedTest
    @CsvSource({"5000, 100, 8", "16384, 100, 8", "1400, 9000, 8", "300, 300, 100", "8192, 5, 3"})
    void rowsAndLayersStayWithinLimitsAndHoldAllTexels(int samples, int rows, int texels) {
        TermsLayout layout = TermsLayout.of("rays", samples, rows, texels, 2);
        assertEquals(samples, layout.samples());
        assertEquals(rows, layout.array().height());
        assertTrue(layout.array().width() <= 16384, layout::toString);
        assertTrue(layout.together() == 1
                || layout.array().bytes() / layout.array().layers() <= 1L << 28);
        assertTrue(layout.together() * layout.layersPerGrid() >= texels, layout::toString);
        assertEquals(2 * layout.layersPerGrid(), layout.array().layers());
    }
}
