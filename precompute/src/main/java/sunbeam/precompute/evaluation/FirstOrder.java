package sunbeam.precompute.evaluation;

import java.util.Optional;

/**
 * Where a grating's first order is looked for: periods between two lengths.
 *
 * @param shortest metres
 * @param longest metres
 */
public record FirstOrder(double shortest, double longest) {
    /** Periods from {@code period / factor} to {@code period * factor}. */
    public static FirstOrder around(double period, double factor) {
        return new FirstOrder(period / factor, period * factor);
    }

    /** The period in the middle, in ratios, metres. */
    public double middle() {
        return Math.sqrt(shortest * longest);
    }

    /**
     * Angles theta_r to the viewer, radians, ascending and evenly spaced over all that see the order, on either side of the
     * mirror, at any wavelength between two (metres); empty where none does.
     */
    public Optional<double[]> angles(
            GratingPlane plane, double shortestWavelength, double longestWavelength, int count) {
        double horizon = Math.sin(plane.largestThetaR());
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int sign = -1; sign <= 1; sign += 2) {
            double near = -plane.lightAlong() - sign * shortestWavelength / longest;
            double far = -plane.lightAlong() - sign * longestWavelength / shortest;
            double left = Math.max(-horizon, Math.min(near, far));
            double right = Math.min(horizon, Math.max(near, far));
            low = left < right ? Math.min(low, left) : low;
            high = left < right ? Math.max(high, right) : high;
        }
        if (!(low < high)) {
            return Optional.empty();
        }
        double[] angles = new double[count];
        for (int i = 0; i < count; i++) {
            angles[i] = Math.asin(low) + (Math.asin(high) - Math.asin(low)) * i / (count - 1);
        }
        return Optional.of(angles);
    }
}
