package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.PRESET;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.GridSampling.TermsLayout;
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.spectrum.FourierTable;

/** The memory that a plan estimates is that of its tables. */
class SamplingTablesTest {
    private static final HeightMap SKIN = Surfaces.random(64, 64, 50e-9, 400e-9, 5);
    private static final CieTable CIE = CieTable.load();

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
        VisibleRange map = VisibleRange.of(new Direction(0, 0, 1));
        return new Planner(HeightLevels.of(SKIN), CIE, Roughness.Cache.NONE)
                .plan(new TableChoices(choices), GaussianArea.of(choices), map);
    }

    private static ShaderTables tables(SpectrumPlan plan, MethodUse use) {
        FourierTable table = plan.fourierTable(HeightLevels.of(SKIN), done -> {});
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
