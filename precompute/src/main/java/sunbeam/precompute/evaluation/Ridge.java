package sunbeam.precompute.evaluation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;
import org.apache.commons.math3.stat.descriptive.StatisticalSummary;
import sunbeam.precompute.evaluation.GratingPlane.FirstOrder;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.numerics.Lagrange;

/** Peaks of a response: one angle theta_r, radians, at each wavelength that has one, meters, ascending. */
public record Ridge(GratingPlane plane, double[] wavelengths, double[] angles) {
    /** Returns the order m, +1 or -1, of wr = -wi + m lambda / d along the grating: 1 if theta_r is above the mirror's angle, else -1. */
    public int order() {
        return plane.u(angles[0]) < 0 ? 1 : -1;
    }

    /** Returns the period d = lambda / |u| at each wavelength, meters. */
    public double[] periods() {
        return IntStream.range(0, wavelengths.length)
                .mapToDouble(i -> wavelengths[i] / Math.abs(plane.u(angles[i])))
                .toArray();
    }

    /** Returns the statistics of the periods, as in the thesis's Table 4.1. */
    public StatisticalSummary statistics() {
        return new DescriptiveStatistics(periods());
    }

    /** Way to find the angle of the first order at each wavelength of a response. */
    public enum Peaks {
        /** The strongest ridge, followed through local maxima ({@link RidgeTracker}). */
        RIDGE,

        /** The largest value at each wavelength, which may jump between ridges (thesis algorithm 4.1, wavelengths of its equation 4.3). */
        MAXIMUM,

        /** The same for C wavelengths, labeled in steps of 1 / C of their range, as algorithm 4.1 is written, instead of 1 / (C - 1). */
        MAXIMUM_BY_COUNT;

        /** Returns the peaks, if any: of a ridge within these periods, or of all angles; sigma_f of the window is in cycles per meter. */
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

    /**
     * Follows the ridge of a first order: the frequency f = u / lambda = +-1 / d with the largest sum of the response along its curve, the
     * grating equation. Local maxima near that curve are candidates at each wavelength; dynamic programming (Viterbi) finds the path through
     * them that is bright and bends least, so that neither a brighter neighboring ridge nor a gap makes it jump. A peak's angle is the maximum
     * of the parabola through the logarithms of the three samples around it.
     */
    record RidgeTracker(ResponseMatrix response, double sigmaFrequency) {
        // Deviations of the window's spectrum: well below a ridge's width of 1.7.
        private static final double STEP = 1.0 / 6;
        // Deviations of the window's spectrum: neighboring speckles lie about two apart.
        private static final double CORRIDOR = 2;
        // A step between wavelengths of this many deviations costs as much as a factor e in brightness.
        private static final double STIFFNESS = 0.25;
        // A variance of fewer periods is meaningless.
        private static final int FEWEST = 3;

        /** Local maximum at one wavelength, with the cost of the cheapest path to it and the peak before it, or null. */
        private record Peak(
                double wavelength, double angle, double frequency, double value, double cost, Peak previous) {}

        Optional<Ridge> follow(FirstOrder order) {
            double strongest = 0;
            double frequency = 0;
            double step = STEP * sigmaFrequency;
            for (double length = 1 / order.longest(); length <= 1 / order.shortest() + step; length += step) {
                for (double signed : new double[] {-length, length}) {
                    double strength = strength(signed);
                    frequency = strength > strongest ? signed : frequency;
                    strongest = Math.max(strongest, strength);
                }
            }
            return strongest > 0 ? follow(frequency) : Optional.empty();
        }

        /** Wavelengths whose angle is on the grid count. */
        private double strength(double frequency) {
            return IntStream.range(0, response.values().length)
                    .mapToDouble(row -> response.atFrequency(row, frequency))
                    .filter(value -> !Double.isNaN(value))
                    .sum();
        }

        /** Returns the ridge near a frequency u / lambda, in cycles per meter, without wavelengths that have no peak there. */
        Optional<Ridge> follow(double frequency) {
            List<Peak> paths = List.of();
            for (int row = 0; row < response.values().length; row++) {
                List<Peak> peaks = peaks(row, frequency);
                paths = peaks.isEmpty() ? paths : connected(paths, peaks);
            }
            Deque<Peak> path = new ArrayDeque<>();
            Peak last =
                    paths.stream().min(Comparator.comparingDouble(Peak::cost)).orElse(null);
            for (Peak peak = last; peak != null; peak = peak.previous) {
                path.addFirst(peak);
            }
            return path.size() < FEWEST
                    ? Optional.empty()
                    : Optional.of(new Ridge(
                            response.grid().plane(),
                            path.stream().mapToDouble(Peak::wavelength).toArray(),
                            path.stream().mapToDouble(Peak::angle).toArray()));
        }

        private List<Peak> peaks(int row, double frequency) {
            ResponseGrid grid = response.grid();
            double[] values = response.values()[row];
            double wavelength = grid.wavelengths()[row];
            List<Peak> peaks = new ArrayList<>();
            for (int column = 1; column + 1 < values.length; column++) {
                boolean near = Math.abs(grid.plane().u(grid.angles()[column]) / wavelength - frequency)
                        <= CORRIDOR * sigmaFrequency;
                boolean maximum = values[column] > values[column - 1] && values[column] >= values[column + 1];
                if (near && maximum) {
                    double shift = Lagrange.top(values[column - 1], values[column], values[column + 1]);
                    double step = 0.5 * (grid.angles()[column + 1] - grid.angles()[column - 1]);
                    double angle = grid.angles()[column] + shift * step;
                    peaks.add(new Peak(wavelength, angle, grid.plane().u(angle) / wavelength, values[column], 0, null));
                }
            }
            return peaks;
        }

        private List<Peak> connected(List<Peak> before, List<Peak> peaks) {
            double brightest = peaks.stream().mapToDouble(Peak::value).max().orElseThrow();
            return peaks.stream()
                    .map(peak -> {
                        Peak from = before.stream()
                                .min(Comparator.comparingDouble(other -> other.cost + bendCost(other, peak)))
                                .orElse(null);
                        double pathCost = from == null ? 0 : from.cost + bendCost(from, peak);
                        double cost = pathCost + Math.log(brightest / peak.value);
                        return new Peak(peak.wavelength, peak.angle, peak.frequency, peak.value, cost, from);
                    })
                    .toList();
        }

        private double bendCost(Peak from, Peak to) {
            double deviations = (to.frequency - from.frequency) / (STIFFNESS * sigmaFrequency);
            return deviations * deviations;
        }
    }
}
