package sunbeam.precompute.numerics;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.descriptive.rank.Percentile.EstimationType;
import org.apache.commons.math3.stat.ranking.NaNStrategy;

/** Quantiles of samples, linear between neighbors (type 7 of Hyndman and Fan, "Sample Quantiles in Statistical Packages", 1996). */
public final class Quantiles {
    // Differences of infinite neighbors are NaN. Interpolation towards this value exceeds INFINITE_FROM.
    private static final double IN_PLACE_OF_INFINITY = 1e300;
    private static final double INFINITE_FROM = 1e280;

    private Quantiles() {}

    /** Returns the quantile 0..1 of samples without NaN, up to 1e280 or positive infinity; NaN without samples. */
    public static double of(double[] samples, double share) {
        if (share == 0) {
            return StatUtils.min(samples);
        }
        double[] finite = Arrays.stream(samples)
                .map(sample -> Math.min(sample, IN_PLACE_OF_INFINITY))
                .toArray();
        double quantile = new Percentile()
                .withEstimationType(EstimationType.R_7)
                .withNaNStrategy(NaNStrategy.FAILED)
                .evaluate(finite, 100 * share);
        return quantile >= INFINITE_FROM ? Double.POSITIVE_INFINITY : quantile;
    }
}
