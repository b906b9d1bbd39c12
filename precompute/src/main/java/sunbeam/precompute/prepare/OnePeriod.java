package sunbeam.precompute.prepare;

/** Recognises heights that are one period, or very few, of a surface. */
public final class OnePeriod {
    // Larger patches are scans: half of sunlight's coherence length.
    private static final double LARGEST = 32.5e-6;
    // Along each axis; more are a grating that happens to fit.
    private static final int MOST_PERIODS = 2;
    // Of the heights' variance, in one frequency; noise has less in each.
    private static final double LEAST_SHARE = 0.4;
    // What rounding to 8 bits leaves of an even ramp is a thousandth of it.
    private static final double EVEN = 5e-3;

    private OnePeriod() {}

    /** Whether the surface goes on smoothly across all borders and one low frequency holds most of it. */
    public static boolean is(HeightField field) {
        if (Math.max(field.width(), field.height()) > LARGEST || hasGaps(field)) {
            return false;
        }
        return Seam.of(field).fits() && lowShare(field) >= LEAST_SHARE;
    }

    /** Whether the heights are one even ramp and nothing else: a tilted mirror, or one period of a blazed grating. */
    public static boolean isRamp(HeightField field) {
        if (Math.max(field.width(), field.height()) > LARGEST || hasGaps(field)) {
            return false;
        }
        Tilt tilt = Tilt.of(field);
        return tilt.rise() > 0 && 1 - tilt.share() < EVEN * EVEN;
    }

    private static boolean hasGaps(HeightField field) {
        for (double height : field.heights()) {
            if (!Double.isFinite(height)) {
                return true;
            }
        }
        return false;
    }

    /** The largest share of the variance that a wave of at most two periods along each axis has. */
    private static double lowShare(HeightField field) {
        double[] heights = Levelling.MEAN.apply(field).heights();
        double variance = 0;
        for (double height : heights) {
            variance += height * height / heights.length;
        }
        double largest = 0;
        for (int jy = 0; jy <= MOST_PERIODS; jy++) {
            for (int jx = jy == 0 ? 1 : -MOST_PERIODS; jx <= MOST_PERIODS; jx++) {
                largest = Math.max(largest, power(field, heights, jx, jy));
            }
        }
        // A bin and its mirror image make one wave.
        return variance > 0 ? 2 * largest / variance : 0;
    }

    private static double power(HeightField field, double[] heights, int jx, int jy) {
        double real = 0;
        double imaginary = 0;
        for (int i = 0; i < heights.length; i++) {
            int column = i % field.columns();
            int row = i / field.columns();
            double turns = (double) jx * column / field.columns() + (double) jy * row / field.rows();
            real += heights[i] * Math.cos(2 * Math.PI * turns);
            imaginary += heights[i] * Math.sin(2 * Math.PI * turns);
        }
        return (real * real + imaginary * imaginary) / ((double) heights.length * heights.length);
    }
}
