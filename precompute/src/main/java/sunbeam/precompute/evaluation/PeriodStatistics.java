package sunbeam.precompute.evaluation;

import org.apache.commons.math3.stat.StatUtils;

/**
 * A period from its values at several wavelengths, as in the thesis's Table 4.1.
 *
 * @param count number of wavelengths, at least 2
 * @param mean metres
 * @param variance over the wavelengths, unbiased, square metres
 */
public record PeriodStatistics(int count, double mean, double variance) {

    /**
     * Of one period for each wavelength.
     *
     * @throws IllegalArgumentException for fewer than two
     */
    public static PeriodStatistics of(double[] periods) {
        if (periods.length < 2) {
            throw new IllegalArgumentException("a variance needs two values, got " + periods.length);
        }
        return new PeriodStatistics(periods.length, StatUtils.mean(periods), StatUtils.variance(periods));
    }

    /** Of the mean, as if the wavelengths' values were independent, metres. */
    public double standardError() {
        return Math.sqrt(variance / count);
    }
}
