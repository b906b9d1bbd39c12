package sunbeam.app.viewer.loop;

/**
 * Controls the resolution of moving pictures: the finest scale whose frames take at most {@link #BUDGET_NANOSECONDS}, else the coarsest.
 * Measured times decay, so that finer scales are tried again. Used by the render thread only.
 */
final class FrameScale {
    /** Time of a frame at 30 frames a second. */
    static final long BUDGET_NANOSECONDS = 33_000_000;

    // Reductions of width and height. Coarser pictures would be unrecognizable.
    private static final double[] DIVISORS = {1, 1.25, 1.6, 2, 3, 4};
    // Decay of the measured times per frame.
    private static final double FORGETTING = 0.99;
    // A scale that is too slow is recorded as SLOW times its time, at most SLOWEST budgets; at 30 frames a second it is
    // tried again after
    // one to three seconds.
    private static final double SLOW = 1.5;
    private static final double SLOWEST = 2.5;
    // Weight of the newest frame in the running mean.
    private static final double NEWEST = 0.25;

    // Nanoseconds of a frame at each scale; 0 before the first.
    private final double[] taken = new double[DIVISORS.length];
    private int scale;
    // Time of the last frame at this scale, and running mean; 0 before the first.
    private long previous;
    private double mean;

    /** Returns the divisor of the picture's width and height. */
    double divisor() {
        return DIVISORS[scale];
    }

    /** Records the time of a frame at the current scale and chooses the next scale. */
    void frame(long nanoseconds) {
        for (int i = 0; i < taken.length; i++) {
            taken[i] *= FORGETTING;
        }
        // The shorter of two frames: the first waits for the driver, and other programs can delay single frames.
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
