package sunbeam.app.viewer;

import java.util.Arrays;

/**
 * At what resolution moving pictures are drawn: the finest whose frames keep to {@link #BUDGET_NANOSECONDS}. A scale that takes
 * longer gives way to a coarser one, unless that saves next to nothing, as where a large mesh takes the time. What other scales
 * took is forgotten slowly, so that they are tried again. Belongs to the render thread.
 */
final class FrameScale {
    /** Sixteen frames a second: with the window's own time, input to screen stays near 100 ms. */
    static final long BUDGET_NANOSECONDS = 60_000_000;

    private static final int[] DIVISORS = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48};
    // Of the budget, for a finer scale: lest the scale swings to and fro.
    private static final double MARGIN = 0.8;
    // A coarser scale whose frames take more than this share saves next to nothing.
    private static final double NO_GAIN = 0.8;
    // Budgets.
    private static final double MOST_REMEMBERED = 1.5;
    // With each frame, of the time of other scales.
    private static final double FORGETTING = 0.99;

    // Nanoseconds of a frame; NaN where none has been drawn.
    private final double[] taken = new double[DIVISORS.length];
    private int index;
    // The finer scale that was given up for this one.
    private int left;
    private double leftTaken;
    private double previous;
    // At this scale.
    private int frames;

    /** @param divisor to begin with */
    FrameScale(int divisor) {
        Arrays.fill(taken, Double.NaN);
        left = DIVISORS.length;
        begin(Arrays.binarySearch(DIVISORS, divisor));
    }

    /** The picture has a {@code divisor}-th of columns and rows. */
    int divisor() {
        return DIVISORS[index];
    }

    /** Takes note of what a frame at this scale took; the next may have another. */
    void frame(long nanoseconds) {
        frames++;
        if (frames == 1) {
            return; // the driver compiles shaders and makes room for pictures of another size
        }
        // A single frame may have been held up by something else.
        double latest = Math.min(previous, (double) nanoseconds);
        previous = (double) nanoseconds;
        for (int i = 0; i < taken.length; i++) {
            taken[i] = i == index ? latest : FORGETTING * taken[i];
        }
        if (frames == 3 && left < index && latest > NO_GAIN * leftTaken) {
            Arrays.fill(taken, left + 1, index + 1, 2 * leftTaken);
            begin(left);
        } else if (frames == 2 && left < index) {
            return; // one more, before it is judged
        } else if (taken[index] > BUDGET_NANOSECONDS) {
            coarsen();
        } else if (index > 0 && ofFiner() <= MARGIN * BUDGET_NANOSECONDS) {
            begin(index - 1);
        }
    }

    private double ofFiner() {
        double finer = taken[index - 1];
        // Where it is not known: as if about half of the time were the pixels'.
        return Double.isNaN(finer) ? taken[index] * DIVISORS[index] / DIVISORS[index - 1] : finer;
    }

    private void coarsen() {
        int next = index + 1;
        if (next == DIVISORS.length || taken[next] > NO_GAIN * taken[index]) {
            return;
        }
        // As far as it may take if all of the time is the pixels'.
        double pixels = taken[index] * DIVISORS[index] * DIVISORS[index];
        while (next < DIVISORS.length - 1 && pixels > (double) BUDGET_NANOSECONDS * DIVISORS[next] * DIVISORS[next]) {
            next++;
        }
        left = index;
        leftTaken = taken[index];
        // Whatever held it up, it is tried again in a second or two.
        taken[index] = Math.min(leftTaken, MOST_REMEMBERED * BUDGET_NANOSECONDS);
        begin(next);
    }

    private void begin(int scale) {
        index = scale;
        left = Math.min(left, index);
        previous = Double.POSITIVE_INFINITY;
        frames = 0;
    }
}
