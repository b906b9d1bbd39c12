package sunbeam.precompute.evaluation;

import java.util.stream.IntStream;
import org.apache.commons.math3.stat.descriptive.StatisticalSummary;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;

/**
 * A followed ridge: where the response peaks at each wavelength.
 *
 * @param plane of the directions
 * @param wavelengths at which it was met, metres, ascending
 * @param angles tops of the parabolas through the logarithms of the three samples at each peak, radians
 */
public record Ridge(GratingPlane plane, double[] wavelengths, double[] angles) {
    /** +1 or -1, the sign of u: -1 on the side of the mirror towards the normal for a light at grazing angles. */
    public int order() {
        return plane.u(angles[0]) < 0 ? -1 : 1;
    }

    /** d = lambda / |u| at each wavelength, metres. */
    public double[] periods() {
        return IntStream.range(0, wavelengths.length)
                .mapToDouble(i -> wavelengths[i] / Math.abs(plane.u(angles[i])))
                .toArray();
    }

    /** Number, mean and variance of the periods over the wavelengths, as in the thesis's Table 4.1. */
    public StatisticalSummary statistics() {
        SummaryStatistics statistics = new SummaryStatistics();
        for (double period : periods()) {
            statistics.addValue(period);
        }
        return statistics.getSummary();
    }
}
