package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.reference.WindowLight;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;

/** One surface by method {@code full}, coherent average, on the GPU and by the reference. */
final class Comparison {
    static final double TOLERANCE = 1e-3;
    /** Power below this counts as none: a tenth of the stray light in any instrument. */
    private static final double FAINTEST = 1e-9;

    private final RenderContext context;
    private final HeightMap map;
    private final FullMethod full;
    private final CieTable cie = CieTable.load();
    private final ReferenceEvaluator reference;

    Comparison(RenderContext context, HeightMap map, double coherenceLength) {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        this.context = context;
        this.map = map;
        this.full = new FullMethod(
                new TableChoices(
                        Optional.of(TOLERANCE), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty()),
                new GaussianArea(window, WindowOrigin.CENTRE, Average.COHERENT));
        this.reference = new ReferenceEvaluator(map, window, WindowOrigin.CENTRE);
    }

    /** Coherent power, ensemble power, rho and brdf of each query, from the shaders. */
    List<float[]> spectral(List<Query> queries) {
        return evaluate(queries, true);
    }

    private List<float[]> evaluate(List<Query> queries, boolean spectral) {
        List<DirectionPair> pairs = queries.stream().map(Query::pair).toList();
        HeightLevels heights = HeightLevels.of(map);
        SpectrumPlan plan =
                new Planner(heights, cie, Roughness.Cache.NONE).plan(full.table(), full.area(), VisibleRange.of(pairs));
        FourierTable table = plan.fourierTable(heights, done -> {});
        MethodUse use = spectral ? MethodUse.SPECTRAL : MethodUse.COLOR;
        try (UploadedTables method =
                        UploadedTables.upload(context, plan.sampling().tables(plan, table, use, cie));
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

    /** Both directions anywhere in the hemisphere, evenly in the disc, and any visible wavelength. */
    static List<Query> anywhere(long seed, int count) {
        SplittableRandom random = new SplittableRandom(seed);
        return IntStream.range(0, count)
                .mapToObj(i -> new Query(
                        new DirectionPair(direction(random), direction(random)), 380e-9 + 400e-9 * random.nextDouble()))
                .toList();
    }

    private static Direction direction(SplittableRandom random) {
        double r = Math.sqrt(random.nextDouble());
        double phi = 2 * Math.PI * random.nextDouble();
        return Direction.ofDisc(r * Math.cos(phi), r * Math.sin(phi));
    }

    /**
     * Light in the xz plane, and the view that sees a frequency.
     *
     * @param thetaDegrees angle of the light to the normal, towards +x
     * @param fx u / lambda, cycles per meter
     * @param fy v / lambda, cycles per meter
     */
    static Query seeing(double thetaDegrees, double fx, double fy, double wavelength) {
        Direction light = Direction.ofDegrees(thetaDegrees, 0);
        Direction view = Direction.ofDisc(-fx * wavelength - light.x(), -fy * wavelength - light.y());
        return new Query(new DirectionPair(light, view), wavelength);
    }

    /** Heights by position in meters; x to the right, y upwards, both 0 at the top left sample. */
    static HeightMap heights(int columns, int rows, double pitch, DoubleBinaryOperator height) {
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = height.applyAsDouble(i % columns * pitch, -(i / columns) * pitch);
        }
        return new HeightMap(columns, rows, pitch, pitch, heights);
    }

    /** Independent heights, spread evenly over the relief. */
    static HeightMap noise(int columns, int rows, double relief, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return heights(columns, rows, 50e-9, (x, y) -> random.nextDouble() * relief);
    }
}
