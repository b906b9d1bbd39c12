package sunbeam.app.viewer.loop;

/**
 * Chooses the resolution of pictures drawn while something moves: the finest scale whose frames take at most {@link #BUDGET_NANOSECONDS},
 * else the coarsest. Measured times decay, so that finer scales are tried again. Used by the render thread only.
 */
final class FrameScale {
    /** Time of a frame at 30 frames a second. */
    static final long BUDGET_NANOSECONDS = 33_000_000;

    // Divisors of width and height, by scale. Coarser pictures would be unrecognizable.
    private static final double[] DIVISORS = {1, 1.25, 1.6, 2, 3, 4};
    private static final double DECAY = 0.99;
    // A scale over budget is recorded as SLOW times its measured time, at most SLOWEST budgets. It is tried again when
    // this has decayed below the budget, in one to three seconds.
    private static final double SLOW = 1.5;
    private static final double SLOWEST = 2.5;
    private static final double NEWEST = 0.25;

    // Recorded time of a frame at each scale; 0 before the first.
    private final double[] recorded = new double[DIVISORS.length];
    private int scale;
    // Time of the last frame at the current scale, and running mean, in nanoseconds; 0 before the first.
    private long previous;
    private double mean;

    double divisor() {
        return DIVISORS[scale];
    }

    void frame(long nanoseconds) {
        for (int i = 0; i < recorded.length; i++) {
            recorded[i] *= DECAY;
        }
        // Take the shorter of two frames: the first waits for the driver, and other programs can delay single frames.
        if (previous > 0) {
            long least = Math.min(previous, nanoseconds);
            mean = mean == 0 ? least : mean + NEWEST * (least - mean);
            recorded[scale] = mean > BUDGET_NANOSECONDS ? Math.min(SLOW * mean, SLOWEST * BUDGET_NANOSECONDS) : mean;
        }
        previous = nanoseconds;
        int finest = 0;
        while (finest < recorded.length - 1 && recorded[finest] > BUDGET_NANOSECONDS) {
            finest++;
        }
        if (finest != scale) {
            scale = finest;
            previous = 0;
            mean = 0;
        }
    }
}
