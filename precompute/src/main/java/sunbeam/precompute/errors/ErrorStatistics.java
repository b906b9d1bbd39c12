package sunbeam.precompute.errors;

import java.util.Arrays;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.text.Text;

/**
 * What a set of errors comes to; all NaN when the set is empty.
 *
 * @param count number of errors
 * @param median half of them are below it
 * @param percentile95 95 of 100 are below it
 * @param percentile98 98 of 100 are below it
 * @param maximum the largest
 * @param mean of all
 */
public record ErrorStatistics(int count, double median, double percentile95, double percentile98, double maximum, double mean) {
    /** Tolerances that the 95th percentile may have. */
    public static final double PROMISED_PERCENTILE = 3;

    /** Of errors in any order; a NaN counts as infinitely wrong. */
    public static ErrorStatistics of(double... errors) {
        double[] counted = Arrays.stream(errors)
                .map(error -> Double.isNaN(error) ? Double.POSITIVE_INFINITY : error)
                .toArray();
        return new ErrorStatistics(
                counted.length,
                Quantiles.of(counted, 0.5),
                Quantiles.of(counted, 0.95),
                Quantiles.of(counted, 0.98),
                Quantiles.of(counted, 1),
                Arrays.stream(counted).average().orElse(Double.NaN));
    }

    /** Returns true if these, or none at all, keep a tolerance: in the median, and three times it at the 95th percentile. */
    public boolean keep(double tolerance) {
        return count == 0 || (median <= tolerance && percentile95 <= PROMISED_PERCENTILE * tolerance);
    }

    /**
     * What so few errors leave unknown, to be put behind other words; empty where they are enough. That all of n lie below the
     * 95th percentile of what they were drawn from has the chance 0.95^n.
     */
    public String doubt() {
        double chance = Math.pow(0.95, count);
        return count == 0 || chance < 0.05
                ? ""
                : Text.format(
                        "; of so few, the true 95th percentile exceeds their maximum with a chance of %.0f %%: give more places",
                        100 * chance);
    }

    /** For people: {@code median 1.2e-04, 95th percentile 3.4e-04, maximum 5.6e-03}. */
    @Override
    public String toString() {
        return Text.format("median %.2g, 95th percentile %.2g, maximum %.2g", median, percentile95, maximum);
    }
}
