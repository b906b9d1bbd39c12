package sunbeam.app.viewer;

import java.util.Arrays;

/**
 * At what resolution what moves is drawn by tables of colors: in full wherever its frames take {@link #BUDGET_NANOSECONDS}, else the
 * finest that does. Each scale's time is remembered, and a finer scale that took too long is tried again once that is a while ago.
 * What part of a frame does not depend on the number of pixels shows when the scale changes: fewer pixels are no remedy for a
 * mesh that takes longer than the budget by itself. Belongs to the render thread.
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
    // Of the budget, beyond what does not depend on the number of pixels: fewer of them would not make frames much
    // faster.
    private static final double LEAST_SHARE = 1 / 3.0;
    // Of what was found not to depend on the number of pixels: frames that take less show that it is out of date.
    private static final double OUTDATED = 0.8;
    private static final double MOST_REMEMBERED = 1.3;
    // Of the time of finer scales, with each frame: what was a third too long is tried again after two seconds.
    private static final double FORGETTING = 0.995;

    // Nanoseconds of a frame; NaN where none has been drawn.
    private final double[] taken = new double[PreviewScale.divisors()];
    private int index;
    private double fixed;
    // The frame before at this scale; 0 where it has none.
    private double previous;
    // The finer scale that was left last, and what two of its frames in a row took at least.
    private int leftDivisor;
    private double leftTaken;
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
        double latest = Math.min((double) nanoseconds, MOST_COUNTED * budget());
        double before = taken[index];
        taken[index] = Double.isNaN(before) ? latest : before + NEWEST * (latest - before);
        for (int finer = 0; finer < index; finer++) {
            taken[finer] *= FORGETTING;
        }
        // A single frame may have been held up by something else.
        double least = Math.min(previous, (double) nanoseconds);
        previous = (double) nanoseconds;
        if (least > 0) {
            findFixed(least);
            follow(least);
        }
    }

    private void follow(double least) {
        if (least > budget() && taken[index] > budget()) {
            // The coarsest scale stays, however long it takes.
            if (index < taken.length - 1) {
                coarsen(least);
            }
        } else if (index > 0 && taken[index] <= budget() && ofFiner() <= MARGIN * budget()) {
            index--;
            begin();
        }
    }

    private double budget() {
        return Math.max(BUDGET_NANOSECONDS, fixed + LEAST_SHARE * BUDGET_NANOSECONDS);
    }

    /** Frames of two scales, f + p / l^2 and f + p / d^2, have f. */
    private void findFixed(double least) {
        if (leftDivisor > 0) {
            double left = (double) leftDivisor * leftDivisor;
            double now = (double) divisor() * divisor();
            fixed = Math.max(0, (least * now - leftTaken * left) / (now - left));
            leftDivisor = 0;
        } else if (least < OUTDATED * fixed) {
            fixed = 0;
        }
    }

    private double ofFiner() {
        double ratio = (double) divisor() / PreviewScale.divisor(index - 1);
        return Double.isNaN(taken[index - 1])
                ? taken[index] * (1 - PIXELS_SHARE + PIXELS_SHARE * ratio * ratio)
                : taken[index - 1];
    }

    /** As far as it may take, if all of the time was the pixels'. */
    private void coarsen(double least) {
        double budget = budget();
        double pixels = least * divisor() * divisor();
        leftDivisor = divisor();
        leftTaken = least;
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
        previous = 0;
        isFirst = true;
    }
}
