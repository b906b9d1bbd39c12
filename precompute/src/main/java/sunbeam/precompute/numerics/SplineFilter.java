package sunbeam.precompute.numerics;

/**
 * Recursive filter that turns equally spaced samples into B-spline coefficients. For each pole, it runs forwards and backwards along each
 * column (M. Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16 (1999), table 1 and box
 * 2).
 */
public final class SplineFilter {
    /** Poles of the filters. */
    public static final double CUBIC = Math.sqrt(3) - 2;

    public static final double QUADRATIC = 2 * Math.sqrt(2) - 3;
    // Samples that initialize the forward filter: 0.43^20 is below the rounding of float32.
    private static final int HORIZON = 20;

    private SplineFilter() {}

    /** Filters {@code rows * columns} samples, of at least 11 rows, in place along columns, whose ends continue as mirror images. */
    public static void alongColumns(float[] samples, int rows, int columns, double... poles) {
        double gain = 1;
        for (double pole : poles) {
            gain *= (1 - pole) * (1 - 1 / pole);
        }
        for (int i = 0; i < rows * columns; i++) {
            samples[i] *= (float) gain;
        }
        for (double pole : poles) {
            filter(samples, rows, columns, (float) pole);
        }
    }

    private static void filter(float[] c, int rows, int columns, float pole) {
        float factor = pole;
        for (int row = 1; row < HORIZON; row++) {
            int mirrored = row < rows ? row : 2 * (rows - 1) - row;
            addRow(c, 0, mirrored * columns, factor, columns);
            factor *= pole;
        }
        for (int row = 1; row < rows; row++) {
            addRow(c, row * columns, (row - 1) * columns, pole, columns);
        }
        int last = (rows - 1) * columns;
        float end = pole / (pole * pole - 1);
        for (int i = 0; i < columns; i++) {
            c[last + i] = end * (c[last + i] + pole * c[last - columns + i]);
        }
        for (int at = last - columns; at >= 0; at -= columns) {
            for (int i = 0; i < columns; i++) {
                c[at + i] = pole * (c[at + columns + i] - c[at + i]);
            }
        }
    }

    private static void addRow(float[] c, int to, int from, float factor, int columns) {
        for (int i = 0; i < columns; i++) {
            c[to + i] += factor * c[from + i];
        }
    }
}
