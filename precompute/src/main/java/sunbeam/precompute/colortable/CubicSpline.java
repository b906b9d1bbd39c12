package sunbeam.precompute.colortable;

/**
 * Interpolation by cubic B-splines on equally spaced samples (M. Unser, "Splines: a perfect fit for signal and image
 * processing", IEEE Signal Processing Magazine 16 (1999)): coefficients c_i with sum_i c_i b(x - i) = f(i) at all samples.
 */
final class CubicSpline {
    /** What a sample counts in the coefficient of its neighbor falls by this factor a sample: sqrt(3) - 2. */
    static final double POLE = Math.sqrt(3) - 2;

    // POLE to this power is below the rounding of float32.
    private static final int HORIZON = 16;

    private CubicSpline() {}

    /**
     * Turns samples into coefficients, in place; beyond both ends the samples go on as in a mirror that stands on the last
     * one.
     *
     * @param first index of the first sample in the array
     * @param stride from one sample to the next
     * @param count of the samples; a single one is its own coefficient
     */
    static void toCoefficients(float[] samples, int first, int stride, int count) {
        if (count < 2) {
            return;
        }
        double[] c = new double[count];
        for (int i = 0; i < count; i++) {
            // (1 - POLE) (1 - 1 / POLE) = 6.
            c[i] = 6.0 * samples[first + i * stride];
        }
        c[0] = mirroredStart(c);
        for (int i = 1; i < count; i++) {
            c[i] += POLE * c[i - 1];
        }
        c[count - 1] = POLE / (POLE * POLE - 1) * (c[count - 1] + POLE * c[count - 2]);
        for (int i = count - 2; i >= 0; i--) {
            c[i] = POLE * (c[i + 1] - c[i]);
        }
        for (int i = 0; i < count; i++) {
            samples[first + i * stride] = (float) c[i];
        }
    }

    /** Sum of POLE^i c_i over the mirrored samples. */
    private static double mirroredStart(double[] c) {
        int period = 2 * (c.length - 1);
        double sum = 0;
        double factor = 1;
        for (int i = 0; i < HORIZON; i++) {
            int at = i % period;
            sum += factor * c[at < c.length ? at : period - at];
            factor *= POLE;
        }
        return sum;
    }

    /**
     * As {@link #toCoefficients} along columns, all of a row at once. Rounds to float32 at each step: 1e-7 of what lies beside it,
     * which falls with it.
     *
     * @param plane {@code rows * columns} values; at least 9 rows
     */
    static void alongColumns(float[] plane, int rows, int columns) {
        float pole = (float) POLE;
        float factor = pole;
        for (int row = 1; row < HORIZON; row++) {
            int at = row % (2 * (rows - 1));
            addRow(plane, 0, (at < rows ? at : 2 * (rows - 1) - at) * columns, factor, columns);
            factor *= pole;
        }
        // (1 - POLE) (1 - 1 / POLE) = 6.
        for (int i = 0; i < columns; i++) {
            plane[i] *= 6;
        }
        for (int at = columns; at < rows * columns; at += columns) {
            for (int i = 0; i < columns; i++) {
                plane[at + i] = 6 * plane[at + i] + pole * plane[at - columns + i];
            }
        }
        int last = (rows - 1) * columns;
        float end = pole / (pole * pole - 1);
        for (int i = 0; i < columns; i++) {
            plane[last + i] = end * (plane[last + i] + pole * plane[last - columns + i]);
        }
        for (int at = last - columns; at >= 0; at -= columns) {
            for (int i = 0; i < columns; i++) {
                plane[at + i] = pole * (plane[at + columns + i] - plane[at + i]);
            }
        }
    }

    private static void addRow(float[] plane, int to, int from, float factor, int columns) {
        for (int i = 0; i < columns; i++) {
            plane[to + i] += factor * plane[from + i];
        }
    }

    /**
     * What the four coefficients around a place weigh.
     *
     * @param t the place, from the second of them on, 0..1
     */
    static double[] weights(double t) {
        double s = 1 - t;
        return new double[] {
            s * s * s / 6, 2.0 / 3 - 0.5 * t * t * (2 - t), 2.0 / 3 - 0.5 * s * s * (2 - s), t * t * t / 6
        };
    }
}
