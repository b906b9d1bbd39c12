package sunbeam.precompute.evaluation;

import java.util.stream.IntStream;
import org.apache.commons.math3.stat.descriptive.StatisticalSummary;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;

/**
 * Peaks of a response: one angle at each wavelength.
 *
 * @param wavelengths wavelengths with a peak, meters, ascending
 * @param angles angles theta_r of the peaks, radians
 */
public record Ridge(GratingPlane plane, double[] wavelengths, double[] angles) {
    /** Returns the order, +1 or -1, which is the sign of u: -1 if theta_r is above the mirror's angle, else 1. */
    public int order() {
        return plane.u(angles[0]) < 0 ? -1 : 1;
    }

    /** Returns the period d = lambda / |u| at each wavelength, meters. */
    public double[] periods() {
        return IntStream.range(0, wavelengths.length)
                .mapToDouble(i -> wavelengths[i] / Math.abs(plane.u(angles[i])))
                .toArray();
    }

    /** Returns the statistics of the periods, as in the thesis's Table 4.1. */
    public StatisticalSummary statistics() {
        SummaryStatistics statistics = new SummaryStatistics();
        for (double period : periods()) {
            statistics.addValue(period);
        }
        return statistics.getSummary();
    }
}
