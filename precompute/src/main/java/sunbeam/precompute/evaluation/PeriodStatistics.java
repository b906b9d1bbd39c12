package sunbeam.precompute.evaluation;

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
        double mean = 0;
        for (double period : periods) {
            mean += period / periods.length;
        }
        double sum = 0;
        for (double period : periods) {
            sum += (period - mean) * (period - mean);
        }
        return new PeriodStatistics(periods.length, mean, sum / (periods.length - 1));
    }

    /** Of the mean, as if the wavelengths' values were independent, metres. */
    public double standardError() {
        return Math.sqrt(variance / count);
    }
}
