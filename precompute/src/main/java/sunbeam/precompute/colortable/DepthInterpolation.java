package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Lagrange interpolation of colors along w, between slices in which |w| is constant. Immutable. */
record DepthInterpolation(double[] depths, int taps, double[] denominators) {
    private static final int TAPS = 6;
    private static final int COORDINATES = 3;
    /** Periods of the fastest wave along w in one slice step of the color table (TableDesign). */
    private static final double PERIODS_PER_STEP = 0.06;

    // Largest error of a wave of amplitude 1 between Chebyshev nodes.
    private static final double ERROR = 5e-5;

    private DepthInterpolation(double[] depths, int taps) {
        this(depths, taps, new double[taps]);
        // Equally spaced slices have the same denominators for each first tap.
        Arrays.fill(denominators, 1);
        Arrays.setAll(denominators, tap -> weight(depths[tap], 0, tap));
    }

    /**
     * Returns few slices: the samples' distinct |w| if these are few, else Chebyshev nodes, else (for many nodes) equally spaced ones. At a
     * distance of {@code widestStep} four taps of equally spaced slices suffice.
     */
    static DepthInterpolation fewest(float[] uvw, double widestStep) {
        DoubleSummaryStatistics all = depths(uvw).summaryStatistics();
        double lowest = all.getMin();
        double range = all.getMax() - lowest;
        int nodes = chebyshevNodes(Math.PI * PERIODS_PER_STEP * range / widestStep);
        int most = Math.max(2 * nodes, spaced(range, widestStep));
        double[] distinct = depths(uvw).distinct().limit(most + 1L).sorted().toArray();
        if (distinct.length <= most) {
            return new DepthInterpolation(distinct, 1);
        }
        if (nodes > 2 * TAPS) {
            return equallySpaced(lowest, range, widestStep);
        }
        double[] depths = new double[nodes];
        Arrays.setAll(depths, i -> lowest + 0.5 * range * (1 - Math.cos(Math.PI * (i + 0.5) / nodes)));
        return new DepthInterpolation(depths, nodes);
    }

    private static DoubleStream depths(float[] uvw) {
        return IntStream.range(0, uvw.length / COORDINATES).mapToDouble(i -> Math.abs(uvw[COORDINATES * i + 2]));
    }

    /**
     * Returns the number of nodes that keep {@link #ERROR} for a wave whose phase changes by so many radians from the range's middle to its end:
     * n nodes err by 2 (phase / 2)^n / n!.
     */
    private static int chebyshevNodes(double phase) {
        int nodes = 1;
        double error = phase;
        while (nodes < 2 || (error > ERROR && nodes <= 2 * TAPS)) {
            nodes++;
            error *= phase / (2 * nodes);
        }
        return nodes;
    }

    static DepthInterpolation equallySpaced(double lowest, double range, double widestStep) {
        int slices = spaced(range, widestStep);
        double step = range / (slices - 1);
        return new DepthInterpolation(
                IntStream.range(0, slices).mapToDouble(i -> lowest + i * step).toArray(), TAPS);
    }

    private static int spaced(double range, double widestStep) {
        return Math.max(TAPS, 1 + (int) Math.ceil(range / widestStep));
    }

    int firstTap(double depth) {
        if (taps == depths.length) {
            return 0;
        }
        if (taps == 1) {
            return Arrays.binarySearch(depths, depth);
        }
        int below = (int) ((depth - depths[0]) / (depths[1] - depths[0]));
        return Math.max(0, Math.min(below - taps / 2 + 1, depths.length - taps));
    }

    double weight(double depth, int firstTap, int tap) {
        double weight = 1 / denominators[tap];
        for (int other = 0; other < taps; other++) {
            weight *= other == tap ? 1 : depth - depths[firstTap + other];
        }
        return weight;
    }
}
