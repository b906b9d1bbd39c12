package sunbeam.precompute.colortable;

import java.util.Arrays;

/** Filter between texels, of square roots of X, Y and Z: ringing beside a peak would hide powers of 1e-6, but not roots of 1e-3. */
public enum Interpolation {
    /** Cubic B-splines (Unser, see {@link SplineFilter}): 16 coefficients per look-up. */
    CUBIC("cubicXyz", 0),
    /**
     * Linear interpolation with knots shifted by a fifth of a texel (T. Blu, P. Thevenaz and M. Unser, "Linear interpolation revitalized",
     * IEEE Transactions on Image Processing 13 (2004)): the closest piecewise linear fit, where lines between samples would err 2.4 times
     * as much. 4 coefficients per look-up.
     */
    SHIFTED_LINES("linearXyz", 0.5 * (1 - 1 / Math.sqrt(3)));

    // A spline's prefilter needs at least 11 samples.
    private static final int KEY_SAMPLES = 16;

    private final String shaderFunction;
    private final double shift;

    Interpolation(String shaderFunction, double shift) {
        this.shaderFunction = shaderFunction;
        this.shift = shift;
    }

    public String shaderFunction() {
        return shaderFunction;
    }

    /** Returns name and impulse response for cache keys, so that a changed filter has another key. */
    public String key() {
        float[] impulse = new float[KEY_SAMPLES];
        impulse[KEY_SAMPLES / 2] = 1;
        toCoefficients(impulse, KEY_SAMPLES, 1);
        return name() + " shifted by " + shift + " of " + Arrays.toString(impulse);
    }

    public double shift() {
        return shift;
    }

    /** Prefilters {@code rows * columns} samples along columns, in place; splines need at least 11 rows. */
    void toCoefficients(float[] plane, int rows, int columns) {
        if (this == CUBIC) {
            SplineFilter.alongColumns(plane, rows, columns, SplineFilter.CUBIC);
            return;
        }
        float pole = (float) (-shift / (1 - shift));
        float gain = (float) (1 / (1 - shift));
        for (int at = columns; at < rows * columns; at += columns) {
            for (int i = 0; i < columns; i++) {
                plane[at + i] = gain * plane[at + i] + pole * plane[at - columns + i];
            }
        }
    }

    /** Returns the weights of four coefficients at t, 0..1, from the second to the third. */
    double[] weights(double t) {
        double s = 1 - t;
        return switch (this) {
            case CUBIC ->
                new double[] {
                    s * s * s / 6, 2.0 / 3 - 0.5 * t * t * (2 - t), 2.0 / 3 - 0.5 * s * s * (2 - s), t * t * t / 6
                };
            case SHIFTED_LINES -> new double[] {0, s, t, 0};
        };
    }

    /**
     * Recursive filter that turns equally spaced samples into B-spline coefficients. For each pole, it runs forwards and backwards along each
     * column (M. Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16 (1999), table 1 and box
     * 2).
     */
    public static final class SplineFilter {
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
}
