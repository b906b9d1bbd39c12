package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;

/**
 * Detection of tilted heights that were rounded to steps as high as the leveled relief: the edges of the steps are straight and evenly spaced, as
 * lines of a grating. Second differences along x and y are whole steps, whatever plane was subtracted; the tilt is that of most neighbors.
 */
final class RoundedHeights {
    // Rounding has a variance of 1 / 12 of a step's square; the surface's own may be twice that.
    private static final double OWN = Math.sqrt(3.0 / 12);
    // Over the scan, in steps; heights of two levels are a grating's, and their plane rises by less.
    private static final double LEAST_TILT = 2;
    // Share of a step, far above the rounding of floats and far below that of noise.
    private static final double WHOLE = 0.01;
    // Filled gaps and edges that were leveled.
    private static final double MOST = 0.98;

    private RoundedHeights() {}

    /** Returns the step in meters; empty if the heights are not rounded, or if the relief is higher than rounding makes it. */
    static OptionalDouble step(HeightMap scan) {
        if (scan.columns() < 3 || scan.rows() < 3) {
            return OptionalDouble.empty();
        }
        double deviation = Math.sqrt(StatUtils.variance(scan.heights()));
        double[] bends =
                DoubleStream.concat(bends(scan, 1), bends(scan, scan.columns())).toArray();
        double[] edges =
                Arrays.stream(bends).filter(bend -> bend > WHOLE * deviation).toArray();
        if (edges.length == 0) {
            return OptionalDouble.empty();
        }
        double step = Quantiles.of(edges, 1 - MOST);
        long whole = Arrays.stream(bends)
                .filter(bend -> Math.abs(bend / step - Math.rint(bend / step)) < WHOLE)
                .count();
        double tilt = scan.columns() * slope(scan, 1) + scan.rows() * slope(scan, scan.columns());
        boolean rounded = whole >= MOST * bends.length && tilt >= LEAST_TILT * step && deviation <= OWN * step;
        return rounded ? OptionalDouble.of(step) : OptionalDouble.empty();
    }

    /** Returns sizes of second differences of samples that are apart by 1, along x, or by the number of columns, along y. */
    private static DoubleStream bends(HeightMap scan, int apart) {
        return IntStream.range(apart, scan.heights().length - apart)
                .filter(i -> apart > 1 || (i % scan.columns() > 0 && (i + 1) % scan.columns() > 0))
                .mapToDouble(
                        i -> Math.abs(scan.heights()[i - apart] - 2 * scan.heights()[i] + scan.heights()[i + apart]));
    }

    private static double slope(HeightMap scan, int apart) {
        double[] differences = IntStream.range(apart, scan.heights().length)
                .filter(i -> apart > 1 || i % scan.columns() > 0)
                .mapToDouble(i -> scan.heights()[i] - scan.heights()[i - apart])
                .toArray();
        return Math.abs(Quantiles.of(differences, 0.5));
    }
}
