package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings.FresnelFactor;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.WindowLight;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;

/** Method {@code full} on the GPU in directions at the ends of their ranges; closed forms and laws are those of the reference. */
class FullOnGpuTest extends InAContext {
    private static final double TOLERANCE = 1e-3;
    private static final HeightMap ROUGH = rough();

    private static HeightMap rough() {
        double[] heights = new SplittableRandom(51).doubles(64 * 64, 0, 400e-9).toArray();
        return new HeightMap(64, 64, 50e-9, 50e-9, heights);
    }

    /** Coherence lengths that lead to a grid, to rays and to single orders. */
    @ParameterizedTest
    @ValueSource(doubles = {3e-6, 10e-6, 65e-6})
    void exactlySpecular(double coherenceLength) {
        List<Query> queries = new ArrayList<>();
        for (double theta = 0; theta <= 85; theta += 5) {
            DirectionPair pair = new DirectionPair(Direction.ofDegrees(theta, 30), Direction.ofDegrees(theta, 210));
            queries.add(new Query(pair, 500e-9));
        }
        Comparison comparison = new Comparison(coherenceLength);

        comparison.assertPowers(queries, TOLERANCE);
        comparison.assertColors(queries, TOLERANCE);
    }

    /** Light and view that nearly cancel: factors of 1 + wi . wr lost all digits but one at 89.9 degrees. */
    @Test
    void grazingMirrorsHaveTheirRadianceToo() {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(3e-6);
        List<Query> queries = new ArrayList<>();
        for (double theta : new double[] {89.5, 89.9, 89.99}) {
            queries.add(new Query(
                    new DirectionPair(Direction.ofDegrees(theta, 20), Direction.ofDegrees(theta, 200.01)), 500e-9));
        }
        List<float[]> computed = new Comparison(3e-6).spectral(queries);
        for (int i = 0; i < queries.size(); i++) {
            DirectionPair pair = queries.get(i).pair();
            float power = computed.get(i)[0];
            // Components near 1 are rounded by 6e-8, of a sum of 3.9e-4 at 89.99 degrees: 1.5e-4, and its square.
            assertThat(computed.get(i)[2] / power / Gain.relativeRadiance(pair))
                    .as("rho at %s", pair)
                    .isCloseTo(1, within(3e-4));
            assertThat(computed.get(i)[3] / power / Gain.brdf(pair, window, 500e-9))
                    .as("brdf at %s", pair)
                    .isCloseTo(1, within(3e-4));
        }
    }

    @Test
    void grazingLightAndViewStayFinite() {
        double coherenceLength = 3e-6;
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        List<Query> queries = new ArrayList<>();
        for (double phi = 0; phi < 360; phi += 15) {
            // cos(89.9 degrees) = 1.7e-3, |w| = 3.5e-3; and one of both grazing only.
            queries.add(new Query(
                    new DirectionPair(Direction.ofDegrees(89.9, phi), Direction.ofDegrees(89.9, 100)), 450e-9));
            queries.add(
                    new Query(new DirectionPair(Direction.ofDegrees(89.9, phi), Direction.ofDegrees(20, 100)), 450e-9));
            queries.add(
                    new Query(new DirectionPair(Direction.ofDegrees(30, phi), Direction.ofDegrees(89.9, 100)), 450e-9));
        }
        Comparison comparison = new Comparison(coherenceLength);

        List<float[]> computed = comparison.spectral(queries);

        for (int i = 0; i < queries.size(); i++) {
            float[] result = computed.get(i);
            DirectionPair pair = queries.get(i).pair();
            // The factors are sums and cosines of float32 directions: 89.9 degrees has a cosine right to 4e-5, squared.
            double rho = Gain.relativeRadiance(pair) * result[0];
            double brdf = Gain.brdf(pair, window, 450e-9) * result[0];
            assertThat((double) result[2]).as("rho %d", i).isCloseTo(rho, within(TOLERANCE * rho));
            assertThat((double) result[3]).as("brdf %d", i).isCloseTo(brdf, within(TOLERANCE * brdf));
        }
        comparison.assertPowers(grazing(queries, false), TOLERANCE);
        // Where w vanishes, so does the relief: phases of 0.02 leave 1e-4 of the light beside the specular direction,
        // and an error of the expansion that is 2e-5 of the whole weighs a hundred times as much.
        comparison.assertPowers(grazing(queries, true), 10 * TOLERANCE);
    }

    private static List<Query> grazing(List<Query> queries, boolean both) {
        return queries.stream()
                .filter(query -> (-query.pair().w() < 0.01) == both)
                .toList();
    }

    /** The surface by method {@code full}, coherent average, on the GPU and by the reference. */
    private static final class Comparison {
        /** Power below this counts as none: a tenth of the stray light in any instrument. */
        private static final double FAINTEST = 1e-9;

        private final FullMethod full;
        private final CieTable cie = CieTable.load();
        private final ReferenceEvaluator reference;

        Comparison(double coherenceLength) {
            CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
            this.full = new FullMethod(
                    TableChoices.within(TOLERANCE),
                    new GaussianArea(window, WindowOrigin.CENTRE, Average.COHERENT),
                    FresnelFactor.ONCE);
            this.reference = new ReferenceEvaluator(ROUGH, window, WindowOrigin.CENTRE);
        }

        /** Coherent power, ensemble power, rho and brdf of each query, from the shaders. */
        List<float[]> spectral(List<Query> queries) {
            return evaluate(queries, true);
        }

        private List<float[]> evaluate(List<Query> queries, boolean spectral) {
            List<DirectionPair> pairs = queries.stream().map(Query::pair).toList();
            HeightLevels heights = HeightLevels.of(ROUGH);
            SpectrumPlan plan = new Planner(heights, cie, Roughness.Cache.NONE)
                    .plan(full.table(), full.area(), VisibleRange.of(pairs));
            FourierTable table = plan.fourierTable(heights, done -> {});
            MethodUse use = spectral ? MethodUse.SPECTRAL : MethodUse.COLOR;
            try (UploadedTables method = UploadedTables.upload(context, plan.tables(table, use, cie));
                    DirectionsRenderer renderer = new DirectionsRenderer(context, method, spectral)) {
                return renderer.evaluate(queries, done -> {});
            }
        }

        /** Asserts the promise of {@code --tolerance} for the power, where there is any. */
        void assertPowers(List<Query> queries, double tolerance) {
            List<float[]> computed = spectral(queries);
            assertWithin(tolerance, queries.size(), i -> {
                double exact = reference
                        .powers(queries.get(i).pair(), queries.get(i).wavelength())
                        .coherent();
                return exact < FAINTEST ? -1 : Math.abs(computed.get(i)[0] - exact) / exact;
            });
        }

        /** Asserts the promise of {@code --tolerance} for the colors as vectors, where there is any power. */
        void assertColors(List<Query> queries, double tolerance) {
            List<float[]> computed = evaluate(queries, false);
            ExactLight light = new WindowLight(reference, cie, false);
            assertWithin(tolerance, queries.size(), i -> {
                double[] exact = light.xyz(queries.get(i).pair(), ExactLight.Quadrature.INTEGRATED);
                double difference = 0;
                double length = 0;
                for (int c = 0; c < 3; c++) {
                    difference += Math.pow(computed.get(i)[c] - exact[c], 2);
                    length += Math.pow(exact[c], 2);
                }
                return Math.sqrt(length) < FAINTEST ? -1 : Math.sqrt(difference / length);
            });
        }

        /** @param relative error by number; negative where there is nothing to compare */
        static void assertWithin(double tolerance, int count, IntToDoubleFunction relative) {
            ErrorStatistics errors = ErrorStatistics.of(IntStream.range(0, count)
                    .parallel()
                    .mapToDouble(relative)
                    .filter(error -> !(error < 0))
                    .toArray());
            assertThat(errors.count()).isGreaterThan(4);
            assertThat(errors.keep(tolerance)).as(errors.toString()).isTrue();
        }
    }
}
