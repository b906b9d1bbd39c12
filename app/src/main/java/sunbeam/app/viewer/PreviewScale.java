package sunbeam.app.viewer;

/**
 * At what resolution a moving picture is drawn so that a frame keeps to its time. Immutable; each measured frame gives the
 * next value.
 *
 * @param divisor the preview has a {@code divisor}-th of the picture's columns and rows, one of 1, 2, 3, 4, 6, 8, 12, 16,
 *     24, 32
 */
public record PreviewScale(int divisor) {
    /** Ten frames a second, with time left for the window itself and for a frame that takes longer than the last. */
    public static final long BUDGET_NANOSECONDS = 60_000_000;

    private static final int[] DIVISORS = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
    // A finer step must be foreseen to take less than this share of the budget, lest the scale swings to and fro.
    private static final double MARGIN = 0.7;

    /** Coarse enough for any method's first frame, of which nothing is known yet. */
    public static PreviewScale first() {
        return new PreviewScale(16);
    }

    /**
     * The scale after a frame.
     *
     * @param nanoseconds what a frame at this scale took
     */
    public PreviewScale after(long nanoseconds) {
        double perPixel = (double) nanoseconds * divisor * divisor;
        for (int candidate : DIVISORS) {
            double foreseen = perPixel / ((double) candidate * candidate);
            double allowed = candidate < divisor ? MARGIN * BUDGET_NANOSECONDS : BUDGET_NANOSECONDS;
            if (foreseen <= allowed) {
                return new PreviewScale(candidate);
            }
        }
        return new PreviewScale(DIVISORS[DIVISORS.length - 1]);
    }

    /** Pixels of the preview along a side of the picture; at least 1. */
    public int reduced(int side) {
        return Math.max(1, (side + divisor - 1) / divisor);
    }
}
