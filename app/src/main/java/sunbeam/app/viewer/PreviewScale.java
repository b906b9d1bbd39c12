package sunbeam.app.viewer;

/**
 * At what resolution a moving picture is drawn so that a frame keeps to its time. A frame takes a fixed time, for the
 * mesh and the window, and one per pixel; only the second can be saved. Immutable; each measured frame gives the next
 * value.
 *
 * @param divisor the preview has a {@code divisor}-th of the picture's columns and rows, one of 1, 2, 3, 4, 6, 8, 12, 16,
 *     24, 32
 * @param fixedNanoseconds upper bound of the fixed time: what the fastest frame took
 */
public record PreviewScale(int divisor, double fixedNanoseconds) {
    /**
     * Input that comes just after a frame has begun waits for two of them; with the window's own time that is below
     * 100 ms.
     */
    public static final long BUDGET_NANOSECONDS = 30_000_000;

    private static final int[] DIVISORS = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
    // A finer step must be foreseen to take less than this share of the budget, lest the scale swings to and fro.
    private static final double MARGIN = 0.7;
    // Where the fixed time eats up the budget, pixels still get this share: fewer would not make frames faster.
    private static final double LEAST_SHARE = 1 / 3.0;

    /** Coarse enough for any method's first frame, of which nothing is known yet. */
    public static PreviewScale first() {
        return new PreviewScale(16, Double.MAX_VALUE);
    }

    /**
     * The scale after a frame: as coarse as it must be at once, but one step finer at most.
     *
     * @param nanoseconds what a frame at this scale took
     */
    public PreviewScale after(long nanoseconds) {
        double fixed = Math.min(fixedNanoseconds, (double) nanoseconds);
        double forPixels = (nanoseconds - fixed) * divisor * divisor;
        double allowed = Math.max(BUDGET_NANOSECONDS - fixed, LEAST_SHARE * BUDGET_NANOSECONDS);
        for (int index = Math.max(0, indexOf(divisor) - 1); index < DIVISORS.length; index++) {
            int candidate = DIVISORS[index];
            double foreseen = forPixels / ((double) candidate * candidate);
            if (foreseen <= (candidate < divisor ? MARGIN : 1) * allowed) {
                return new PreviewScale(candidate, fixed);
            }
        }
        return new PreviewScale(DIVISORS[DIVISORS.length - 1], fixed);
    }

    private static int indexOf(int divisor) {
        int index = 0;
        while (DIVISORS[index] < divisor) {
            index++;
        }
        return index;
    }

    /** Pixels of the preview along a side of the picture; at least 1. */
    public int reduced(int side) {
        return Math.max(1, (side + divisor - 1) / divisor);
    }
}
