package sunbeam.precompute.prepare;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;

/**
 * Leveling of measured heights: removes a scan's offset, its tilt, the bow of the scanner, and the offset of each line. Missing samples
 * (NaN, infinities) are ignored and stay missing.
 */
public enum Leveling {
    NONE,
    MEAN,
    /** The least-squares plane a + b x + c y is subtracted. */
    PLANE,
    /** The plane, then each row's mean: removes steps between lines, and all structure that is constant along x. */
    ROWS,
    /** The plane, then each row's median, which is robust against dust. */
    MEDIAN_ROWS,
    /** The least-squares surface of second degree is subtracted: tilt and bow. */
    QUADRATIC;

    // Relative to the relief; a sum over millions of samples rounds less.
    private static final double ROUNDING = 1e-14;

    public boolean takesTilt() {
        return this != NONE && this != MEAN;
    }

    /** Returns the leveled heights, on the same grid. */
    public HeightMap apply(HeightMap field) {
        return switch (this) {
            case NONE -> field;
            case MEAN ->
                isCentered(field) ? field : centered(Polynomial.fit(field, 1).subtracted());
            case PLANE -> centered(Polynomial.fit(field, 3).subtracted());
            case QUADRATIC -> centered(Polynomial.fit(field, 6).subtracted());
            case ROWS, MEDIAN_ROWS -> centered(withoutRows(PLANE.apply(field)));
        };
    }

    /** Then MEAN returns the same map, whose cached properties stay valid. */
    private static boolean isCentered(HeightMap field) {
        double[] heights = field.heights();
        return Math.abs(mean(heights, 0, heights.length)) <= ROUNDING * field.relief();
    }

    /** After {@link #MEDIAN_ROWS} the mean is that of the differences from the medians, else rounding. */
    private static HeightMap centered(HeightMap field) {
        double[] heights = field.heights().clone();
        double mean = mean(heights, 0, heights.length);
        for (int i = 0; i < heights.length; i++) {
            heights[i] -= mean;
        }
        return field.with(heights);
    }

    private HeightMap withoutRows(HeightMap field) {
        double[] heights = field.heights().clone();
        for (int row = 0; row < field.rows(); row++) {
            int start = row * field.columns();
            int end = start + field.columns();
            double offset = this == ROWS ? mean(heights, start, end) : median(heights, start, end);
            for (int i = start; i < end; i++) {
                heights[i] -= offset;
            }
        }
        return field.with(heights);
    }

    private static double mean(double[] heights, int from, int to) {
        return Arrays.stream(heights, from, to)
                .filter(Double::isFinite)
                .average()
                .orElse(0);
    }

    private static double median(double[] heights, int from, int to) {
        double[] known =
                Arrays.stream(heights, from, to).filter(Double::isFinite).toArray();
        return known.length == 0 ? 0 : StatUtils.percentile(known, 50);
    }
}
