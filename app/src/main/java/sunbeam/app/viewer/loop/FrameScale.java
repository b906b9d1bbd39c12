package sunbeam.app.viewer.loop;

/**
 * At what resolution moving pictures are drawn: the finest whose frames keep to {@link #BUDGET_NANOSECONDS}, or else the coarsest. What
 * a scale took is forgotten slowly, so that it is tried again. Belongs to the render thread.
 */
final class FrameScale {
    /** Thirty frames a second. */
    static final long BUDGET_NANOSECONDS = 33_000_000;

    // Coarser pictures are not recognized.
    private static final double[] DIVISORS = {1, 1.25, 1.6, 2, 3, 4};
    // With each frame.
    private static final double FORGETTING = 0.99;
    // What was too slow counts as so many times what it took, and as at most so many budgets: at 30 frames a second it
    // is tried again after
    // one to three seconds.
    private static final double SLOW = 1.5;
    private static final double SLOWEST = 2.5;
    // Of a frame, in the mean over the last ones.
    private static final double NEWEST = 0.25;

    // Nanoseconds of a frame by its scale; 0 where none has been drawn.
    private final double[] taken = new double[DIVISORS.length];
    private int scale;
    // Of the last frame at this scale, and of the last ones in the mean; 0 before.
    private long previous;
    private double mean;

    /** The picture has a {@code divisor}-th of columns and rows. */
    double divisor() {
        return DIVISORS[scale];
    }

    /** Takes note of what a frame at this scale took; the next may have another. */
    void frame(long nanoseconds) {
        for (int i = 0; i < taken.length; i++) {
            taken[i] *= FORGETTING;
        }
        // The first one waits for the driver, and any single one may be held up by something else.
        if (previous > 0) {
            long least = Math.min(previous, nanoseconds);
            mean = mean == 0 ? least : mean + NEWEST * (least - mean);
            taken[scale] = mean > BUDGET_NANOSECONDS ? Math.min(SLOW * mean, SLOWEST * BUDGET_NANOSECONDS) : mean;
        }
        previous = nanoseconds;
        int finest = 0;
        while (finest < taken.length - 1 && taken[finest] > BUDGET_NANOSECONDS) {
            finest++;
        }
        if (finest != scale) {
            scale = finest;
            previous = 0;
            mean = 0;
        }
    }
}
