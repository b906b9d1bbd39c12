package sunbeam.precompute.prepare;

import sunbeam.precompute.optics.HeightMap;

/** Detection of synthetic heights, drawn or computed as one period of a grating: they are constant along one axis. */
public final class OnePeriod {
    // Meters: half of sunlight's coherence length. Larger patches are taken for scans.
    private static final double LARGEST = 32.5e-6;
    // Relative to the relief; measured lines differ by more.
    private static final double SAME = 1e-6;

    private OnePeriod() {}

    /** True if the heights are constant along one axis, up to rounding; false if samples are missing or all heights are equal. */
    public static boolean looksSynthetic(HeightMap field) {
        return Math.max(field.width(), field.height()) <= LARGEST
                && ((field.columns() > 1 && isSame(field, 1, 0)) || (field.rows() > 1 && isSame(field, 0, 1)));
    }

    /** Compares rows with the first one (factors 1, 0), or columns with the first one (factors 0, 1). */
    private static boolean isSame(HeightMap field, int columnFactor, int rowFactor) {
        double largest = 0;
        for (int row = 0; row < field.rows(); row++) {
            for (int column = 0; column < field.columns(); column++) {
                double step = field.at(column, row) - field.at(columnFactor * column, rowFactor * row);
                largest = Math.max(largest, Math.abs(step));
            }
        }
        return field.relief() > 0 && largest <= SAME * field.relief();
    }
}
