package sunbeam.precompute.errors;

import java.util.Arrays;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.text.Text;

/** Statistics of a set of errors; all but the count are NaN for an empty set. */
public record ErrorStatistics(
        int count, double median, double percentile95, double percentile98, double maximum, double mean) {
    /** Multiple of the tolerance. */
    public static final double PERCENTILE_95_LIMIT = 3;

    /** A NaN counts as an infinite error. */
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

    /** True if the median is within a tolerance and the 95th percentile within {@link #PERCENTILE_95_LIMIT} times it. */
    public boolean keep(double tolerance) {
        return count == 0 || (median <= tolerance && percentile95 <= PERCENTILE_95_LIMIT * tolerance);
    }

    /** Returns a remark on too few errors: all of n lie below the 95th percentile with probability 0.95^n. */
    public String doubt() {
        double chance = Math.pow(0.95, count);
        return count == 0 || chance < 0.05
                ? ""
                : Text.format(
                        "; of so few, the true 95th percentile exceeds their maximum with a chance of %.0f %%: give more places",
                        100 * chance);
    }

    /** "1 pair of directions". */
    public String pairs() {
        return count + (count == 1 ? " pair" : " pairs") + " of directions";
    }

    @Override
    public String toString() {
        return Text.format("median %.2g, 95th percentile %.2g, maximum %.2g", median, percentile95, maximum);
    }
}
