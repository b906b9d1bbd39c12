package sunbeam.precompute.evaluation;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.numerics.LogParabola;

/**
 * Follows one ridge through a response. Each wavelength's local maxima near the grating equation's curve are candidates;
 * the path through them that is bright and bends least is found by dynamic programming (Viterbi), so that neither a
 * brighter ridge beside nor a gap makes the curve jump.
 */
public final class RidgeTracker {
    // How far from the curve candidates are looked for, in deviations of the window's spectrum: the speckles of one
    // window stand about two apart.
    private static final double CORRIDOR = 2;
    // A step between wavelengths of this many deviations costs as much as a factor e in brightness.
    private static final double STIFFNESS = 0.25;

    private final ResponseMatrix response;
    private final double sigmaFrequency;

    /** @param sigmaFrequency deviation of the window's spectrum, cycles per metre */
    public RidgeTracker(ResponseMatrix response, double sigmaFrequency) {
        this.response = response;
        this.sigmaFrequency = sigmaFrequency;
    }

    /** A local maximum along one row, and the cheapest way to it. */
    private static final class Peak {
        private final int column;
        private final double angle;
        private final double frequency;
        private final double value;
        private double cost;
        private Peak previous;

        private Peak(int column, double angle, double frequency, double value) {
            this.column = column;
            this.angle = angle;
            this.frequency = frequency;
            this.value = value;
        }
    }

    /** Wavelengths at which there is a candidate, with all of them. */
    private record Row(double wavelength, List<Peak> peaks) {}

    /**
     * Follows the ridge around a frequency u / lambda, in cycles per metre. Wavelengths at which it has no peak within
     * the angles are left out; the ridge may be empty.
     */
    public Ridge follow(double frequency) {
        List<Row> rows = new ArrayList<>();
        for (int row = 0; row < response.values().length; row++) {
            List<Peak> peaks = peaks(row, frequency);
            if (!peaks.isEmpty()) {
                rows.add(new Row(response.grid().wavelengths()[row], peaks));
            }
        }
        for (int i = 0; i < rows.size(); i++) {
            advance(i == 0 ? List.of() : rows.get(i - 1).peaks(), rows.get(i).peaks());
        }
        return traceBack(rows);
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
                peaks.add(new Peak(column, angle, grid.plane().u(angle) / wavelength, values[column]));
            }
        }
        return peaks;
    }

    private void advance(List<Peak> from, List<Peak> to) {
        double brightest = to.stream().mapToDouble(peak -> peak.value).max().orElseThrow();
        for (Peak peak : to) {
            double dimness = Math.log(brightest / peak.value);
            peak.cost = dimness;
            double cheapest = Double.POSITIVE_INFINITY;
            for (Peak before : from) {
                double bend = (peak.frequency - before.frequency) / (STIFFNESS * sigmaFrequency);
                double cost = before.cost + bend * bend + dimness;
                if (cost < cheapest) {
                    cheapest = cost;
                    peak.cost = cost;
                    peak.previous = before;
                }
            }
        }
    }

    private Ridge traceBack(List<Row> rows) {
        double[] wavelengths = rows.stream().mapToDouble(Row::wavelength).toArray();
        double[] angles = new double[wavelengths.length];
        double[] samples = new double[wavelengths.length];
        Peak peak = rows.isEmpty() ? null : cheapest(rows.get(rows.size() - 1).peaks());
        for (int i = wavelengths.length - 1; i >= 0; i--) {
            angles[i] = peak.angle;
            samples[i] = response.grid().angles()[peak.column];
            peak = peak.previous;
        }
        return new Ridge(response.grid().plane(), wavelengths, angles, samples);
    }

    private static Peak cheapest(List<Peak> peaks) {
        Peak best = peaks.get(0);
        for (Peak peak : peaks) {
            best = peak.cost < best.cost ? peak : best;
        }
        return best;
    }
}
