package sunbeam.app.promise;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import jrtr.gl.RenderContext;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.measure.errors.Certificate.Limits;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Bright orders above a rough ground: light goes everywhere, so that the plan takes the patch for rough, and directions that lie
 * together on the orders' skirts still see one order each, whose errors of interpolation nothing evens out.
 */
@NeedsDisplay
class RoughGroundTest {
    private static final double TOLERANCE = 1e-3;
    private static final int SIDE = 64;
    private static final double WIDTH = 12e-6;
    private static final double PERIOD = 3e-6;
    private static final double WAVELENGTH = 500e-9;
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(WIDTH);

    /** What is aimed at, and the surface: the mirror's spot, or the orders of a grating. */
    enum Ground {
        SPECULAR(0, 25e-9),
        GRATING(60e-9, 10e-9);

        private final double depth;
        private final double roughness;

        Ground(double depth, double roughness) {
            this.depth = depth;
            this.roughness = roughness;
        }

        /** The mirror's, or -2, -1, 1, 2 in turn. */
        private int order(int query) {
            int place = query % 4;
            return this == SPECULAR ? 0 : place < 2 ? place - 2 : place - 1;
        }

        private HeightMap map() {
            SplittableRandom random = new SplittableRandom(25);
            return RandomSurface.of(
                    SIDE,
                    SIDE,
                    WIDTH / SIDE,
                    WIDTH / SIDE,
                    (x, y) -> (x * WIDTH / PERIOD % 1 < 0.5 ? depth : 0) + roughness * random.nextGaussian());
        }

        private List<Query> queries() {
            List<Query> queries = new ArrayList<>();
            SplittableRandom random = new SplittableRandom(26);
            for (int i = 0; i < 12; i++) {
                // One to five deviations aside, the light up to 30 degrees from the normal.
                double aside = WAVELENGTH * WINDOW.sigmaFrequency() * (1 + i / 3.0);
                double turn = depth > 0 ? Math.PI / 2 : random.nextDouble(2 * Math.PI);
                Direction light = Direction.ofDegrees(random.nextDouble(30), random.nextDouble(360));
                queries.add(
                        seen(light, order(i) * WAVELENGTH / PERIOD + aside * Math.cos(turn), aside * Math.sin(turn)));
            }
            // So that all of the hemisphere counts, as where a map is drawn.
            queries.add(seen(Direction.ofDegrees(72, 180), 1.9, 0.05));
            queries.add(seen(Direction.ofDegrees(72, 0), -1.9, 0.05));
            return queries;
        }

        private static Query seen(Direction light, double u, double v) {
            return new Query(new DirectionPair(light, Direction.ofDisc(u - light.x(), v - light.y())), WAVELENGTH);
        }
    }

    @ParameterizedTest
    @EnumSource(Ground.class)
    void skirtsOfBrightOrdersKeepTheTolerance(Ground ground) {
        GaussianArea area = new GaussianArea(WINDOW, WindowOrigin.CENTRE, Average.COHERENT);
        RandomCase made = new RandomCase(25, "ground", ground.map(), area, TOLERANCE, "skirts", true, ground.queries());

        RandomCase.Outcome outcome;
        try (RenderContext context = RenderContext.offscreen()) {
            outcome = made.measure(context);
        }

        assertThat(outcome.plan().sampling().summary(outcome.plan().range()))
                .as("the grid whose errors this is about")
                .startsWith("grid");
        // The promise itself: median at most the tolerance, 95th percentile at most three times it.
        assertThat(Limits.of(TOLERANCE).hold(outcome.errors()))
                .as("%s", outcome.errors())
                .isTrue();
    }
}
