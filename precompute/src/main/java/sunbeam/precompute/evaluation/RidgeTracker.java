package sunbeam.precompute.evaluation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.LogParabola;

/**
 * The ridge of a first order in a response. It is looked for among the frequencies f = u / lambda = +-1 / d, along whose curves, the
 * grating equation's, the response is strong on the whole. Then each wavelength's local maxima near that curve are candidates; the path
 * through them that is bright and bends least is found by dynamic programming (Viterbi), so that neither a brighter
 * ridge beside nor a gap makes the curve jump.
 *
 * @param response that is looked at
 * @param sigmaFrequency deviation of the window's spectrum, cycles per metre
 */
public record RidgeTracker(ResponseMatrix response, double sigmaFrequency) {
    // Steps between frequencies, in deviations of the window's spectrum: well below a ridge's width of 1.7.
    private static final double STEP = 1.0 / 6;
    // How far from the curve candidates are looked for, in deviations: the speckles of one window stand about two
    // apart.
    private static final double CORRIDOR = 2;
    // A step between wavelengths of this many deviations costs as much as a factor e in brightness.
    private static final double STIFFNESS = 0.25;
    // A variance of fewer wavelengths says nothing.
    private static final int FEWEST = 3;

    /** A local maximum along one row, the cost of the cheapest way to it, and the peak before it on that way; null for none. */
    private record Peak(double wavelength, double angle, double frequency, double value, double cost, Peak previous) {}

    /** The strongest ridge of an order; empty where none is met at three wavelengths or more. */
    public Optional<Ridge> follow(FirstOrder order) {
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

    /** Sum over the wavelengths at which the frequency's angle is on the grid. */
    private double strength(double frequency) {
        return IntStream.range(0, response.values().length)
                .mapToDouble(row -> response.atFrequency(row, frequency))
                .filter(value -> !Double.isNaN(value))
                .sum();
    }

    /**
     * The ridge around a frequency u / lambda, in cycles per metre. Wavelengths at which it has no peak within
     * the angles are left out; empty where fewer than three remain.
     */
    Optional<Ridge> follow(double frequency) {
        List<Peak> ways = List.of();
        for (int row = 0; row < response.values().length; row++) {
            List<Peak> peaks = peaks(row, frequency);
            ways = peaks.isEmpty() ? ways : reached(ways, peaks);
        }
        Deque<Peak> path = new ArrayDeque<>();
        Peak last = ways.stream().min(Comparator.comparingDouble(Peak::cost)).orElse(null);
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
                double shift = LogParabola.top(values[column - 1], values[column], values[column + 1]);
                double step = 0.5 * (grid.angles()[column + 1] - grid.angles()[column - 1]);
                double angle = grid.angles()[column] + shift * step;
                double met = grid.plane().u(angle) / wavelength;
                peaks.add(new Peak(wavelength, angle, met, values[column], 0, null));
            }
        }
        return peaks;
    }

    /** Peaks of one wavelength with the cheapest way to each from those of the wavelength before. */
    private List<Peak> reached(List<Peak> before, List<Peak> peaks) {
        double brightest = peaks.stream().mapToDouble(Peak::value).max().orElseThrow();
        return peaks.stream()
                .map(peak -> {
                    Peak from = before.stream()
                            .min(Comparator.comparingDouble(other -> other.cost + bend(other, peak)))
                            .orElse(null);
                    double way = from == null ? 0 : from.cost + bend(from, peak);
                    double cost = way + Math.log(brightest / peak.value);
                    return new Peak(peak.wavelength, peak.angle, peak.frequency, peak.value, cost, from);
                })
                .toList();
    }

    private double bend(Peak from, Peak to) {
        double deviations = (to.frequency - from.frequency) / (STIFFNESS * sigmaFrequency);
        return deviations * deviations;
    }
}
