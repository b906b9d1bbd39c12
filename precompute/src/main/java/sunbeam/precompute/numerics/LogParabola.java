package sunbeam.precompute.numerics;

/** The parabola through the logarithms of three positive samples in even steps: exact for a Gaussian. */
public final class LogParabola {
    private LogParabola() {}

    /**
     * Where its top lies, in steps from the middle sample, at most half a step away; 0 where it has none: a sample that is
     * not positive, or logarithms that do not bend downwards.
     */
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
