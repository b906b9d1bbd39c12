package sunbeam.precompute.evaluation;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.descriptive.StatisticalSummary;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import sunbeam.precompute.evaluation.GratingPlane.FirstOrder;

/** Peaks of a response: one angle theta_r, radians, at each wavelength that has one, meters, ascending. */
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

    /** Way to find the angle of the first order at each wavelength of a response. */
    public enum Peaks {
        /** The strongest ridge, followed through local maxima ({@link RidgeTracker}). */
        RIDGE,

        /** The largest value at each wavelength, which may jump between ridges (thesis algorithm 4.1, wavelengths of its equation 4.3). */
        MAXIMUM,

        /** The same for C wavelengths, labeled in steps of 1 / C of their range, as algorithm 4.1 is written, instead of 1 / (C - 1). */
        MAXIMUM_BY_COUNT;

        /**
         * Returns the peaks of a response; empty if there is no ridge.
         *
         * @param order range of periods in which a ridge is searched; maxima are those of all angles
         * @param sigmaFrequency standard deviation of the coherence window's spectrum, cycles per meter
         */
        public Optional<Ridge> of(ResponseMatrix response, FirstOrder order, double sigmaFrequency) {
            if (this == RIDGE) {
                return new RidgeTracker(response, sigmaFrequency).follow(order);
            }
            double[] wavelengths = response.grid().wavelengths();
            double[] labels = this == MAXIMUM ? wavelengths : byCount(wavelengths);
            double[] angles = Arrays.stream(response.values())
                    .mapToDouble(row -> response.grid().angles()[largest(row)])
                    .toArray();
            return Optional.of(new Ridge(response.grid().plane(), labels, angles));
        }

        private static double[] byCount(double[] wavelengths) {
            int count = wavelengths.length;
            double step = (wavelengths[count - 1] - wavelengths[0]) / count;
            return IntStream.range(0, count)
                    .mapToDouble(i -> wavelengths[0] + step * i)
                    .toArray();
        }

        private static int largest(double[] row) {
            return IntStream.range(0, row.length).reduce(0, (best, column) -> row[column] > row[best] ? column : best);
        }
    }
}
