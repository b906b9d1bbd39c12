package sunbeam.precompute.evaluation;

import java.util.Optional;

/** Range of periods, in meters, in which a grating's first order is searched. */
public record FirstOrder(double shortest, double longest) {
    public static FirstOrder around(double period, double factor) {
        return new FirstOrder(period / factor, period * factor);
    }

    /** Returns the geometric mean of the range, meters. */
    public double middle() {
        return Math.sqrt(shortest * longest);
    }

    /**
     * Returns evenly spaced angles theta_r to the viewer, radians. They span all directions that see the order +1 or -1 at a wavelength
     * between two limits (meters); empty if no direction does.
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
