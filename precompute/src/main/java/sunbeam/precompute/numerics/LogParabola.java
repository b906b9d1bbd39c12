package sunbeam.precompute.numerics;

/** Parabola through the logarithms of three equally spaced, positive samples; exact for a Gaussian. */
public final class LogParabola {
    private LogParabola() {}

    /** Returns the maximum in steps from the middle, within half a step; 0 if a sample is not positive or the logarithms not concave. */
    public static double top(double before, double here, double after) {
        double logBefore = Math.log(before);
        double logAfter = Math.log(after);
        double curvature = logBefore - 2 * Math.log(here) + logAfter;
        if (!(curvature < 0) || !Double.isFinite(curvature)) {
            return 0;
        }
        return Math.max(-0.5, Math.min(0.5, 0.5 * (logBefore - logAfter) / curvature));
    }
}
