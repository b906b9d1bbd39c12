package sunbeam.app.certificate;

import java.util.Arrays;
import java.util.Locale;

/**
 * What a set of errors comes to; all NaN when the set is empty.
 *
 * @param count number of errors
 * @param median half of them are below it
 * @param percentile95 95 of 100 are below it
 * @param maximum the largest
 */
public record ErrorStatistics(int count, double median, double percentile95, double maximum) {

    /** A tolerance holds for the median; the 95th percentile may be this many times it. */
    public static final double PERCENTILE_FACTOR = 3;

    /** Of errors in any order; a NaN counts as infinitely wrong. */
    public static ErrorStatistics of(double... errors) {
        double[] sorted = Arrays.stream(errors)
                .map(error -> Double.isNaN(error) ? Double.POSITIVE_INFINITY : error)
                .sorted()
                .toArray();
        return new ErrorStatistics(sorted.length, quantile(sorted, 0.5), quantile(sorted, 0.95), quantile(sorted, 1));
    }

    /** Linear between neighbours, so that the extremes are quantiles 0 and 1. */
    private static double quantile(double[] sorted, double share) {
        if (sorted.length == 0) {
            return Double.NaN;
        }
        double position = share * (sorted.length - 1);
        int below = (int) position;
        int above = Math.min(sorted.length - 1, below + 1);
        double fraction = position - below;
        // An infinite neighbour counts only where it is reached.
        return fraction == 0 ? sorted[below] : sorted[below] * (1 - fraction) + sorted[above] * fraction;
    }

    /** Whether the median is at most the tolerance and the 95th percentile at most three times it; true when empty. */
    public boolean meets(double tolerance) {
        return count == 0 || (median <= tolerance && percentile95 <= PERCENTILE_FACTOR * tolerance);
    }

    /** For people: {@code median 1.2e-04, 95th percentile 3.4e-04, maximum 5.6e-03}. */
    @Override
    public String toString() {
        return String.format(
                Locale.ROOT, "median %.2g, 95th percentile %.2g, maximum %.2g", median, percentile95, maximum);
    }
}
