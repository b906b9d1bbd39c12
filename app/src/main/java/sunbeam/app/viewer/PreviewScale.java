package sunbeam.app.viewer;

/**
 * At what resolution a moving picture is drawn so that a frame keeps to its time. A frame takes some time for the mesh and
 * the body, and some for the pixels of diffracted light; it is the second that a scale saves. Immutable; each measured frame
 * gives the next value.
 *
 * @param divisor the preview has a {@code divisor}-th of the picture's columns and rows, one of 1 to 8, 10, 12, 14, 16,
 *     20, 24, 32, 40, 48
 * @param pixelNanoseconds what the pixels of the picture in full resolution would take, by the latest frames; NaN before
 *     the first
 */
public record PreviewScale(int divisor, double pixelNanoseconds) {
    /**
     * Input that comes just after a frame has begun waits for two of them; with the window's own time that is below
     * 100 ms.
     */
    public static final long BUDGET_NANOSECONDS = 34_000_000;

    private static final int[] DIVISORS = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 32, 40, 48};
    // A finer step must be foreseen to take less than this share of the budget, lest the scale swings to and fro.
    private static final double MARGIN = 0.8;
    // Where the rest eats up the budget, pixels still get this share: fewer would not make frames much faster.
    private static final double LEAST_SHARE = 1 / 3.0;
    // Weight of the latest frame; a single one may have been held up by something else.
    private static final double NEWEST = 0.5;

    /** Coarse enough for any method's first frame, of which nothing is known yet. */
    public static PreviewScale first() {
        return new PreviewScale(16, Double.NaN);
    }

    /**
     * The scale after a frame: as coarse as the estimate wants at once, but one step finer at most.
     *
     * @param nanoseconds what a frame at this scale took
     * @param fixed the part of it that does not depend on the scale
     */
    public PreviewScale after(long nanoseconds, long fixed) {
        double latest = (double) (nanoseconds - fixed) * divisor * divisor;
        double pixels =
                Double.isNaN(pixelNanoseconds) ? latest : pixelNanoseconds + NEWEST * (latest - pixelNanoseconds);
        double allowed = Math.max((double) BUDGET_NANOSECONDS - fixed, LEAST_SHARE * BUDGET_NANOSECONDS);
        for (int index = Math.max(0, indexOf(divisor) - 1); index < DIVISORS.length; index++) {
            int candidate = DIVISORS[index];
            double foreseen = pixels / ((double) candidate * candidate);
            if (foreseen <= (candidate < divisor ? MARGIN : 1) * allowed) {
                return new PreviewScale(candidate, pixels);
            }
        }
        return new PreviewScale(DIVISORS[DIVISORS.length - 1], pixels);
    }

    /** How many there are, from 1 on. */
    static int divisors() {
        return DIVISORS.length;
    }

    static int divisor(int index) {
        return DIVISORS[index];
    }

    /** Of a divisor, or of the next larger one. */
    static int indexOf(int divisor) {
        int index = 0;
        while (DIVISORS[index] < divisor) {
            index++;
        }
        return index;
    }
}
