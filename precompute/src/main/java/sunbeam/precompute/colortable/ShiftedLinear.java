package sunbeam.precompute.colortable;

/**
 * Linear interpolation on equally spaced samples with knots that lie behind them by a fifth of their distance (T. Blu, P. Thevenaz and
 * M. Unser, "Linear interpolation revitalized", IEEE Transactions on Image Processing 13 (2004)): as close to what was sampled
 * as straight lines on as many knots can be, where lines from sample to sample err by 2.4 times as much, and always to the same side of a
 * bend.
 */
final class ShiftedLinear {
    /** Of the knots, in samples: (1 - 1 / sqrt(3)) / 2, for which the error's leading term is least. */
    static final double SHIFT = 0.5 * (1 - 1 / Math.sqrt(3));

    // What a sample counts in the coefficient behind it; CubicSpline's pole is the same number.
    private static final double POLE = -SHIFT / (1 - SHIFT);

    private ShiftedLinear() {}

    /**
     * Turns samples into values at the knots behind them, in place, so that lines between these pass through all samples; before the
     * first sample all are as the first. Rounds to float32 at each step.
     *
     * @param plane {@code rows * columns} values, filtered along columns
     */
    static void alongColumns(float[] plane, int rows, int columns) {
        float pole = (float) POLE;
        float gain = (float) (1 / (1 - SHIFT));
        for (int at = columns; at < rows * columns; at += columns) {
            for (int i = 0; i < columns; i++) {
                plane[at + i] = gain * plane[at + i] + pole * plane[at - columns + i];
            }
        }
    }
}
