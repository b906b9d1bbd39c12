package sunbeam.precompute.prepare;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;

/**
 * What is subtracted from measured heights: a scan sits micrometres, at times millimetres, above zero, is tilted against
 * the microscope and bent by its scanner, and each of its lines has an offset of its own. Missing samples (NaN, infinities)
 * take no part and stay missing.
 */
public enum Levelling {
    /** Heights as they are. */
    NONE,
    /** The mean height is subtracted. */
    MEAN,
    /** The least-squares plane a + b x + c y is subtracted. */
    PLANE,
    /** The plane, then each row's mean: steps between the scan's lines go, and with them all that is constant along x. */
    ROWS,
    /** The plane, then each row's median, which single grains of dust do not draw. */
    MEDIAN_ROWS,
    /** The least-squares surface of second degree is subtracted: tilt and bow. */
    QUADRATIC;

    // Of the relief: a sum of some million differences from the mean leaves less.
    private static final double ROUNDING = 1e-14;

    /** Whether a plane goes with what is subtracted. */
    public boolean takesTilt() {
        return this != NONE && this != MEAN;
    }

    /** The levelled heights, on the same grid. */
    public HeightMap apply(HeightMap field) {
        return switch (this) {
            case NONE -> field;
            case MEAN ->
                isCentred(field) ? field : centred(Polynomial.fit(field, 1).subtracted());
            case PLANE -> centred(Polynomial.fit(field, 3).subtracted());
            case QUADRATIC -> centred(Polynomial.fit(field, 6).subtracted());
            case ROWS, MEDIAN_ROWS -> centred(withoutRows(PLANE.apply(field)));
        };
    }

    /** Whether the mean is 0 but for rounding: then it stays, and with it what is known of the heights. */
    private static boolean isCentred(HeightMap field) {
        double[] heights = field.heights();
        return Math.abs(mean(heights, 0, heights.length)) <= ROUNDING * field.relief();
    }

    /** What rounding, and the fit's, left of the mean: sums over values that are large against their differences. */
    private static HeightMap centred(HeightMap field) {
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

    /** Of the samples that are there; 0 where none is. */
    private static double mean(double[] heights, int from, int to) {
        return Arrays.stream(heights, from, to)
                .filter(Double::isFinite)
                .average()
                .orElse(0);
    }

    private static double median(double[] heights, int from, int to) {
        double[] there =
                Arrays.stream(heights, from, to).filter(Double::isFinite).toArray();
        return there.length == 0 ? 0 : StatUtils.percentile(there, 50);
    }
}
