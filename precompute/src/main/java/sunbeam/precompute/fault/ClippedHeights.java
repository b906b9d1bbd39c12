package sunbeam.precompute.fault;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;
import sunbeam.precompute.units.Decimals;

/**
 * Heights that end where the instrument's range, or a file's, does. Many samples at exactly the highest height are no proof:
 * an image of few levels has them, and so has a flat-topped grating that somebody drew. Clipped are heights whose highest level has
 * many times the samples of the next, is reached without a wall, and belongs to a surface that is noisy elsewhere, more than by
 * rounding to its levels, or tilted with plateaus that stay level and are of many widths.
 */
final class ClippedHeights {
    private static final double LEAST_SHARE = 0.002;
    private static final int FEWEST = 20;
    // Over the samples of each of the next two levels.
    private static final double PILE = 4;
    // Of the relief, in one step down from a plateau: a wall.
    private static final double WALL = 0.25;
    // White noise has sqrt(252 / 70) = 1.9; waves of ten samples or more 0.6 at most.
    private static final double NOISY = 1.2;
    // Differences of degree 5 of noise of deviation 1 have sqrt(252); their median distance from 0 is 0.6745 of that.
    private static final double MEDIAN_OF_FIFTH = 0.6745 * Math.sqrt(252);
    // Of a level: rounding alone makes 0.29 to 0.41.
    private static final double ABOVE_ROUNDING = 0.6;
    private static final int MOST_PLACES = 100_000;
    // Widths of plateaus, of the middle one: a drawn grating's differ by a sample.
    private static final double UNEVEN = 0.3;
    private static final int UNEVEN_SAMPLES = 3;
    // Of the relief, as the plane's rise.
    private static final double TILTED = 0.05;

    private final Measured scan;
    private final BitSet unmeasured;
    private final DoubleSupplier tilt;

    /**
     * @param unmeasured rows that are left out
     * @param tilt finds the rise of the scan's plane, metres
     */
    ClippedHeights(Measured scan, BitSet unmeasured, DoubleSupplier tilt) {
        this.scan = scan;
        this.unmeasured = unmeasured;
        this.tilt = tilt;
    }

    List<ScanFault> faults() {
        return Stream.of(fault(1), fault(-1)).flatMap(Optional::stream).toList();
    }

    /**
     * The three highest levels and how many samples have each.
     *
     * @param levels highest first, metres; minus infinity where there are no more
     * @param counts of samples
     * @param samples in all
     */
    private record Top(double[] levels, long[] counts, long samples) {}

    /** @param sign 1 for the highest heights, -1 for the lowest */
    private Optional<ScanFault> fault(int sign) {
        Top top = top(sign);
        long count = top.counts[0];
        boolean pile = count >= FEWEST
                && count >= LEAST_SHARE * top.samples
                && count >= PILE * Math.max(top.counts[1], top.counts[2]);
        if (!pile || !isCut(sign, top, -top(-sign).levels[0])) {
            return Optional.empty();
        }
        return Optional.of(ScanFault.lasting(String.format(
                Locale.ROOT,
                "%s %% of the samples lie at exactly the %s height: heights are clipped there, and what lies %s is lost",
                Decimals.rounded(100.0 * count / top.samples, 2),
                sign > 0 ? "highest" : "lowest",
                sign > 0 ? "above" : "below")));
    }

    private Top top(int sign) {
        double[] levels = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        long[] counts = new long[3];
        long samples = 0;
        for (int row = 0; row < scan.rows(); row++) {
            for (int column = 0; column < scan.columns() && !unmeasured.get(row); column++) {
                double height = sign * scan.at(column, row);
                if (Double.isFinite(height)) {
                    samples++;
                    if (height >= levels[2]) {
                        count(height, levels, counts);
                    }
                }
            }
        }
        return new Top(levels, counts, samples);
    }

    private static void count(double height, double[] levels, long[] counts) {
        int place = height > levels[0]
                ? 0
                : height == levels[0] ? -1 : height > levels[1] ? 1 : height == levels[1] ? -2 : 2;
        if (place < 0) {
            counts[-place - 1]++;
        } else if (place == 2 && height == levels[2]) {
            counts[2]++;
        } else {
            for (int i = 2; i > place; i--) {
                levels[i] = levels[i - 1];
                counts[i] = counts[i - 1];
            }
            levels[place] = height;
            counts[place] = 1;
        }
    }

    /**
     * Whether the surface would go on beyond the level.
     *
     * @param lowest height of all, with the sign
     */
    private boolean isCut(int sign, Top top, double lowest) {
        double relief = top.levels[0] - lowest;
        if (!(relief > 0)) {
            return false;
        }
        Plateaus plateaus = plateaus(sign, top.levels[0]);
        if (plateaus.step > WALL * relief) {
            return false;
        }
        double level = top.levels[0] - top.levels[1];
        return isNoisy(sign * top.levels[0], sign * lowest, level)
                || (plateaus.uneven && tilt.getAsDouble() > TILTED * relief);
    }

    /**
     * Unbroken runs of samples at a level, along rows.
     *
     * @param step down to their neighbours, the median, metres
     * @param uneven whether they are of many widths
     */
    private record Plateaus(double step, boolean uneven) {}

    private Plateaus plateaus(int sign, double level) {
        double[] steps = new double[64];
        double[] widths = new double[64];
        int stepCount = 0;
        int widthCount = 0;
        for (int row = 0; row < scan.rows(); row++) {
            for (int column = 0; column < scan.columns() && !unmeasured.get(row); column++) {
                int first = column;
                while (column < scan.columns() && sign * scan.at(column, row) == level) {
                    column++;
                }
                if (column > first) {
                    widths = grown(widths, widthCount + 1);
                    widths[widthCount++] = column - first;
                    steps = grown(steps, stepCount + 2);
                    for (int beside : new int[] {first - 1, column}) {
                        if (beside >= 0 && beside < scan.columns() && Double.isFinite(scan.at(beside, row))) {
                            steps[stepCount++] = level - sign * scan.at(beside, row);
                        }
                    }
                }
            }
        }
        double[] sorted = Arrays.copyOf(widths, widthCount);
        double middle = RowSteps.median(sorted);
        double range = sorted[(int) (0.9 * (widthCount - 1))] - sorted[(int) (0.1 * (widthCount - 1))];
        double step = stepCount == 0 ? Double.POSITIVE_INFINITY : RowSteps.median(Arrays.copyOf(steps, stepCount));
        return new Plateaus(step, range >= UNEVEN_SAMPLES && range >= UNEVEN * middle);
    }

    private static double[] grown(double[] values, int needed) {
        return needed <= values.length ? values : Arrays.copyOf(values, Math.max(needed, 2 * values.length));
    }

    /** Whether the heights between the extremes have noise beyond the rounding to levels so far apart. */
    private boolean isNoisy(double extreme, double opposite, double level) {
        long places = (long) scan.rows() * Math.max(0, scan.columns() - 5);
        int stride = (int) Math.max(1, places / MOST_PLACES);
        double[] fourth = new double[(int) (places / stride) + 1];
        double[] fifth = new double[fourth.length];
        int count = 0;
        for (long place = 0; place < places; place += stride) {
            int row = (int) (place / (scan.columns() - 5));
            int column = (int) (place % (scan.columns() - 5));
            if (unmeasured.get(row)) {
                continue;
            }
            boolean free = true;
            double[] h = new double[6];
            for (int i = 0; i < 6; i++) {
                h[i] = scan.at(column + i, row);
                free &= Double.isFinite(h[i]) && h[i] != extreme && h[i] != opposite;
            }
            if (free) {
                fourth[count] = Math.abs(h[0] - 4 * h[1] + 6 * h[2] - 4 * h[3] + h[4]);
                fifth[count++] = Math.abs(h[5] - 5 * h[4] + 10 * h[3] - 10 * h[2] + 5 * h[1] - h[0]);
            }
        }
        double smooth = RowSteps.median(Arrays.copyOf(fourth, count));
        double rough = RowSteps.median(Arrays.copyOf(fifth, count));
        // False where there is no such place.
        return smooth > 0 && rough >= NOISY * smooth && rough >= ABOVE_ROUNDING * MEDIAN_OF_FIFTH * level;
    }
}
