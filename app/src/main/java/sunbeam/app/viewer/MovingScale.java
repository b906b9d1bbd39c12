package sunbeam.app.viewer;

import java.util.Arrays;

/**
 * At what resolution what moves is drawn by tables of colours: in full wherever its frames take {@link #BUDGET_NANOSECONDS}, else the
 * finest that does. What part of a frame
 * depends on the number of pixels is not known, as processors are shared with the window's own painting: each scale's time is
 * remembered instead, and a finer scale that took too long is tried again once that is a while ago. Belongs to the render
 * thread.
 */
final class MovingScale {
    /**
     * What full resolution is worth: frames of 45 ms, as two processors take while the model turns, leave input to screen below 100 ms
     * nearly always, and one that something else holds up is not yet a reason for a coarser scale.
     */
    static final long BUDGET_NANOSECONDS = 60_000_000;

    // A finer scale must be foreseen to take less than this share of the budget, lest the scale swings to and fro.
    private static final double MARGIN = 0.8;
    // Of a frame's time, until a finer scale has been tried.
    private static final double PIXELS_SHARE = 0.6;
    // Weight of the latest frame; a single one may have been held up by something else.
    private static final double NEWEST = 0.25;
    // Of budgets: a frame that was held up for longer tells no more.
    private static final double MOST_COUNTED = 3;
    private static final double MOST_REMEMBERED = 1.3;
    // Of the time of finer scales, with each frame: what was a third too long is tried again after two seconds.
    private static final double FORGETTING = 0.995;

    // Nanoseconds of a frame; NaN where none has been drawn.
    private final double[] taken = new double[PreviewScale.divisors()];
    private int index;
    // The driver makes room for pictures of another size.
    private boolean isFirst = true;

    MovingScale() {
        Arrays.fill(taken, Double.NaN);
    }

    /** The picture has a {@code divisor}-th of columns and rows. */
    int divisor() {
        return PreviewScale.divisor(index);
    }

    /** Takes note of what a frame at this scale took, but for its first; the next may have another. */
    void frame(long nanoseconds) {
        if (isFirst) {
            isFirst = false;
            return;
        }
        double budget = BUDGET_NANOSECONDS;
        double latest = Math.min((double) nanoseconds, MOST_COUNTED * budget);
        double before = taken[index];
        taken[index] = Double.isNaN(before) ? latest : before + NEWEST * (latest - before);
        for (int finer = 0; finer < index; finer++) {
            taken[finer] *= FORGETTING;
        }
        if (taken[index] > budget) {
            // The coarsest scale stays, however long it takes.
            if (index < taken.length - 1) {
                coarsen(budget);
            }
        } else if (index > 0 && ofFiner() <= MARGIN * budget) {
            index--;
            begin();
        }
    }

    private double ofFiner() {
        double ratio = (double) divisor() / PreviewScale.divisor(index - 1);
        return Double.isNaN(taken[index - 1])
                ? taken[index] * (1 - PIXELS_SHARE + PIXELS_SHARE * ratio * ratio)
                : taken[index - 1];
    }

    /** As far as it may take, if all of the time was the pixels'. */
    private void coarsen(double budget) {
        double pixels = taken[index] * divisor() * divisor();
        do {
            // Whatever held it up, all is tried again soon.
            taken[index] = Math.min(pixels / ((double) divisor() * divisor()), MOST_REMEMBERED * budget);
            index++;
        } while (index < taken.length - 1 && pixels > budget * divisor() * divisor());
        begin();
    }

    /** At another scale; what it took earlier is out of date. */
    private void begin() {
        taken[index] = Double.NaN;
        isFirst = true;
    }
}
