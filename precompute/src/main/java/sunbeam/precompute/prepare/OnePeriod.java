package sunbeam.precompute.prepare;

import sunbeam.precompute.optics.HeightMap;

/** Recognises heights that somebody drew or computed as a period of a grating: lines that are the same all along one axis. */
public final class OnePeriod {
    // Larger patches are scans: half of sunlight's coherence length.
    private static final double LARGEST = 32.5e-6;
    // Of the relief: rounding of computed heights. No instrument measures lines as alike.
    private static final double SAME = 1e-6;

    private OnePeriod() {}

    /** False of heights of which some are missing, and of a side beyond 32.5 um. */
    public static boolean isDrawn(HeightMap field) {
        return Math.max(field.width(), field.height()) <= LARGEST
                && ((field.columns() > 1 && isSame(field, 1, 0)) || (field.rows() > 1 && isSame(field, 0, 1)));
    }

    /** Whether all heights are those of the first row (factors 1, 0) or column (0, 1), and not all one. */
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
