package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.List;
import java.util.Optional;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Neighborhood;
import sunbeam.precompute.plan.Sampling.OrderSampling;
import sunbeam.precompute.plan.Sampling.OrderSampling.BandRule;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTables.MethodUse;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;

/** Mesa's software renderer silently ends loops after 65,535 steps; the partial sums must be refused. */
class LoopLimitTest extends InAContext {
    private static final GaussianArea AREA =
            new GaussianArea(CoherenceWindow.ofCoherenceLength(30e-6), WindowOrigin.CENTRE, Average.ENSEMBLE);
    private static final int RADIUS = 15;
    private static final List<Query> ASKED =
            List.of(new Query(new DirectionPair(Direction.ofDisc(0.5, 0.2), Direction.ofDisc(0.1, 0.3)), 500e-9));

    @Test
    void partialSumsOfEndedLoopsAreRefused() {
        assumeTrue(context.info().renderer().contains("llvmpipe"), "only llvmpipe is known to end loops");
        // 961 bins at some hundred wavelengths, more than 65,535 together.
        assertThatThrownBy(() -> evaluate())
                .isInstanceOf(GraphicsException.class)
                .hasMessageContaining("65,535");
    }

    private static List<float[]> evaluate() {
        double[] heights = new double[64];
        heights[27] = 200e-9;
        Surface surface =
                Surface.of(new Patch("grain", new HeightMap(8, 8, 200e-9, 200e-9, heights), "made up", List.of()));
        SpectrumPlan planned = surface.planner()
                .plan(
                        TableChoices.within(1e-3),
                        AREA,
                        VisibleRange.of(List.of(ASKED.get(0).pair())));
        OrderSampling sampling = new OrderSampling(
                new Neighborhood(RADIUS, Neighborhood.Anchor.NEAREST),
                Optional.empty(),
                new BandRule(100, 0.1, 5e3, 50e3));
        SpectrumPlan plan = new SpectrumPlan(
                planned.tolerance(),
                planned.range(),
                planned.expansion(),
                planned.range().bandX(surface.map().width(), RADIUS + 1),
                planned.range().bandY(surface.map().height(), RADIUS + 1),
                AREA,
                sampling);
        ShaderTables tables =
                sampling.tables(plan, plan.fourierTable(surface.levels(), done -> {}), MethodUse.COLOR, surface.cie());
        try (UploadedTables method = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, false)) {
            return renderer.evaluate(ASKED, done -> {});
        }
    }
}
