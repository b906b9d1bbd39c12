package sunbeam.app.promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.spectrum.FourierTable;

/**
 * A surface, window, average, tolerance and directions, all drawn from one seed: method {@code full} must keep its
 * tolerance on any.
 *
 * @param colors whether X, Y, Z are compared, else powers
 */
record RandomCase(
        long seed,
        String kind,
        HeightMap map,
        GaussianArea area,
        double tolerance,
        String aim,
        boolean colors,
        List<DirectionQuery> queries) {
    private static final double[] TOLERANCES = {1e-2, 1e-3, 1e-4};
    private static final int POWERS = 60;
    private static final int COLORS = 12;
    // Both the reference and, under long windows, its integral over wavelengths cost by the sample.
    private static final int MOST_SAMPLES = 128;
    private static final int MOST_SAMPLES_OF_COLORS = 40;
    private static final double FINEST_PITCH = 10e-9;
    private static final double COARSEST_PITCH = 1e-6;
    private static final double LONGEST_SIDE = 100e-6;
    private static final double SHORTEST_WINDOW = 1e-6;
    private static final double LONGEST_WINDOW = 1e-3;
    // The reference sums the window's samples at each of hundreds of wavelengths.
    private static final double LONGEST_IN_SAMPLES = 600;
    // Samples in a coherence length: with fewer than 4 the planner refuses.
    private static final double FEWEST_SAMPLES = 5;

    static RandomCase of(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        RandomSurface kind = oneOf(random, RandomSurface.values());
        Aim aim = oneOf(random, Aim.values());
        boolean colors = random.nextInt(3) == 0;
        HeightMap map = kind.draw(
                random,
                colors ? MOST_SAMPLES_OF_COLORS : MOST_SAMPLES,
                between(random, FINEST_PITCH, COARSEST_PITCH),
                LONGEST_SIDE);
        double shortest = Math.max(SHORTEST_WINDOW, FEWEST_SAMPLES * Math.max(map.pitchX(), map.pitchY()));
        double longest = colors ? LONGEST_IN_SAMPLES * Math.min(map.pitchX(), map.pitchY()) : LONGEST_WINDOW;
        double coherenceLength = between(random, shortest, Math.max(shortest, Math.min(longest, LONGEST_WINDOW)));
        GaussianArea area = new GaussianArea(
                CoherenceWindow.ofCoherenceLength(coherenceLength),
                oneOf(random, WindowOrigin.values()),
                oneOf(random, Average.values()));
        double tolerance = TOLERANCES[random.nextInt(TOLERANCES.length)];
        List<DirectionQuery> queries = new ArrayList<>();
        for (int i = 0; i < (colors ? COLORS : POWERS); i++) {
            double wavelength = Aim.wavelength(random);
            DirectionPair pair = aim.draw(random, map, wavelength, area.window().sigmaFrequency());
            queries.add(new DirectionQuery(pair, wavelength));
        }
        return new RandomCase(seed, words(kind), map, area, tolerance, words(aim), colors, queries);
    }

    private static String words(Enum<?> value) {
        return value.toString().toLowerCase(Locale.ROOT);
    }

    /** Equally often in each octave. */
    private static double between(SplittableRandom random, double least, double most) {
        return least * Math.pow(most / least, random.nextDouble());
    }

    private static <T> T oneOf(SplittableRandom random, T[] values) {
        return values[random.nextInt(values.length)];
    }

    record Outcome(ErrorStatistics errors, SpectrumPlan plan) {}

    /** Compares method {@code full} with the reference on all directions that are bright enough. */
    Outcome measure(RenderContext context) {
        return measure(context, exact());
    }

    Outcome measure(RenderContext context, double[][] exact) {
        SpectrumPlan plan = plan();
        List<float[]> results = evaluate(context, plan);
        List<Comparison> compared = IntStream.range(0, exact.length)
                .mapToObj(i -> new Comparison(computed(results, i), exact[i], 1))
                .toList();
        return new Outcome(Comparison.relative(compared), plan);
    }

    private double[] computed(List<float[]> results, int row) {
        float[] result = results.get(row);
        if (colors) {
            return new double[] {result[0], result[1], result[2]};
        }
        return new double[] {area.average() == Average.ENSEMBLE ? result[1] : result[0]};
    }

    SpectrumPlan plan() {
        VisibleRange range =
                VisibleRange.of(queries.stream().map(DirectionQuery::pair).toList());
        return surface().planner().plan(TableChoices.within(tolerance), area, range);
    }

    List<float[]> evaluate(RenderContext context, SpectrumPlan plan) {
        Surface surface = surface();
        FourierTable table = plan.fourierTable(surface.map(), done -> {});
        MethodUse use = colors ? MethodUse.COLOR : MethodUse.SPECTRAL;
        try (UploadedTables method = UploadedTables.upload(context, plan.tables(table, use, surface.cie()));
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, !colors)) {
            return renderer.evaluate(queries, done -> {});
        }
    }

    RandomCase with(double otherTolerance) {
        return new RandomCase(seed, kind, map, area, otherTolerance, aim, colors, queries);
    }

    private Surface surface() {
        return new Surface(map, "case " + seed, CieTable.load());
    }

    /** X, Y, Z, or the power of the average alone, of each query. */
    double[][] exact() {
        ExactLight light = area.over(map, surface().cie());
        return queries.parallelStream()
                .map(query -> colors
                        ? light.xyz(query.pair(), ExactLight.Quadrature.INTEGRATED)
                        : new double[] {light.power(query.pair(), query.wavelength())})
                .toArray(double[][]::new);
    }

    @Override
    public String toString() {
        String size = map.columns() + " x " + map.rows() + " samples, relief " + map.relief() + " m, window ";
        String length = area.window().coherenceLength() + " m on the " + words(area.origin()) + ", ";
        String result = words(area.average()) + (colors ? " XYZ " : " power ") + aim + ", tolerance " + tolerance;
        return "seed " + seed + ": " + kind + ", " + size + length + result;
    }

    enum Aim {
        SPECULAR,
        ORDER,
        SKIRT,
        VALLEY,
        GRAZING,
        ANYWHERE;

        private static final int MOST_TRIES = 1000;
        private static final double LOWEST_COSINE = 0.01;
        private static final double GRAZING_COSINE = 0.05;

        /**
         * A pair of directions.
         *
         * @param wavelength meters, at which orders are aimed at
         * @param sigmaFrequency of the window, cycles per meter
         */
        DirectionPair draw(SplittableRandom random, HeightMap map, double wavelength, double sigmaFrequency) {
            for (int tries = 0; tries < MOST_TRIES; tries++) {
                Direction light = hemisphere(random, this == GRAZING ? GRAZING_COSINE : 1);
                Direction view = this == GRAZING || this == ANYWHERE
                        ? hemisphere(random, 1)
                        : aimed(random, light, map, wavelength, sigmaFrequency);
                if (view.z() > LOWEST_COSINE) {
                    return new DirectionPair(light, view);
                }
            }
            // The valleys of a patch smaller than a wavelength lie beyond the horizon.
            return ANYWHERE.draw(random, map, wavelength, sigmaFrequency);
        }

        private Direction aimed(
                SplittableRandom random, Direction light, HeightMap map, double wavelength, double sigmaFrequency) {
            double fx = 0;
            double fy = 0;
            if (this != SPECULAR) {
                int axis = random.nextInt(3);
                double half = this == VALLEY ? 0.5 : 0;
                fx = axis == 1 ? 0 : (order(random, map.width(), wavelength) + half) / map.width();
                fy = axis == 0 ? 0 : (order(random, map.height(), wavelength) + half) / map.height();
            }
            double distance = sigmaFrequency
                    * switch (this) {
                        case SPECULAR -> 4 * random.nextDouble();
                        case SKIRT -> random.nextDouble(1, 4.5);
                        default -> random.nextDouble();
                    };
            double angle = random.nextDouble(2 * Math.PI);
            double x = -light.x() - wavelength * (fx + distance * Math.cos(angle));
            double y = -light.y() - wavelength * (fy + distance * Math.sin(angle));
            return Direction.ofDisc(x, y);
        }

        private static int order(SplittableRandom random, double period, double wavelength) {
            int last = (int) Math.floor(2 * period / wavelength);
            return random.nextInt(-last, last + 1);
        }

        /** Equal areas of the sphere have equal heights. */
        private static Direction hemisphere(SplittableRandom random, double highest) {
            double z = random.nextDouble(LOWEST_COSINE, highest);
            double phi = random.nextDouble(2 * Math.PI);
            double sine = Math.sqrt(1 - z * z);
            return new Direction(sine * Math.cos(phi), sine * Math.sin(phi), z);
        }

        static double wavelength(SplittableRandom random) {
            return random.nextDouble(CieTable.MINIMUM_WAVELENGTH, CieTable.MAXIMUM_WAVELENGTH);
        }
    }
}
