package sunbeam.precompute.evaluation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import sunbeam.precompute.numerics.LogParabola;

/**
 * Ridges of a response: frequencies f = u / lambda = +-1 / d along whose curves, the grating equation's, the response is
 * strong on average over all wavelengths.
 */
public final class RidgeSearch {
    // Steps between frequencies, in deviations of the window's spectrum: well below a ridge's width of 1.7.
    private static final double STEP = 1.0 / 6;
    // Wavelengths of which a curve must lie within the angles.
    private static final double LEAST_SHARE = 0.5;

    private RidgeSearch() {}

    /**
     * A ridge.
     *
     * @param frequency u / lambda, cycles per metre; negative on the side of the mirror that is away from the light
     * @param strength mean response along it
     */
    public record Candidate(double frequency, double strength) {
        /** The period d of the grating equation in first order, metres. */
        public double period() {
            return 1 / Math.abs(frequency);
        }
    }

    /**
     * All ridges whose period lies between two lengths, the strongest first, on both sides of the mirror.
     *
     * @param shortest metres
     * @param longest metres
     * @param sigmaFrequency deviation of the window's spectrum, cycles per metre
     */
    public static List<Candidate> search(
            ResponseMatrix response, double shortest, double longest, double sigmaFrequency) {
        List<Candidate> found = new ArrayList<>();
        double step = STEP * sigmaFrequency;
        int count = 1 + (int) Math.ceil((1 / shortest - 1 / longest) / step);
        for (int sign = -1; sign <= 1; sign += 2) {
            double before = 0;
            double here = 0;
            // One step beyond both ends, so that a ridge at an end has neighbors.
            for (int i = -1; i <= count + 1; i++) {
                double after = strength(response, sign * (1 / longest + i * step));
                if (i > 0 && here > before && here >= after) {
                    double top = 1 / longest + (i - 1 + LogParabola.top(before, here, after)) * step;
                    found.add(new Candidate(sign * top, here));
                }
                before = here;
                here = after;
            }
        }
        found.sort(Comparator.comparingDouble(Candidate::strength).reversed());
        return found;
    }

    /** Mean over the wavelengths at which the frequency's angle is on the grid; 0 where these are too few. */
    private static double strength(ResponseMatrix response, double frequency) {
        int rows = response.values().length;
        double sum = 0;
        int inside = 0;
        for (int row = 0; row < rows; row++) {
            double value = response.atFrequency(row, frequency);
            if (!Double.isNaN(value)) {
                sum += value;
                inside++;
            }
        }
        return inside >= LEAST_SHARE * rows ? sum / inside : 0;
    }
}
