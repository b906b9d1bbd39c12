package sunbeam.precompute.plan;

/**
 * How one tolerance, the relative error of power and XYZ, is shared out. The shares were set by measurement: {@code
 * sunbeam accuracy} shows that the errors they lead to stay below the tolerance.
 *
 * @param value relative error, {@link #FINEST}..{@link #COARSEST}
 */
public record Tolerances(double value) {
    /** What float32 tables and shaders reach; {@code reference} goes further. */
    public static final double FINEST = 1e-5;

    /**
     * Down to here the 95th percentile of the power's error stays below three times the tolerance. Below, the median keeps
     * the tolerance, but float32 leaves up to {@link #FLOAT32_PERCENTILE} (docs/accuracy).
     */
    static final double FINEST_CERTAIN = 2e-5;

    /** The 95th percentile of the power's relative error that float32 leaves, as measured. */
    static final double FLOAT32_PERCENTILE = 4.2e-5;

    public static final double COARSEST = 1;
    public static final double STANDARD = 1e-3;

    /**
     * Root mean square error of the expansion over the surface. Weak directions see more of it than the mean, because
     * what is left out falls off more slowly with frequency than what is kept: beside the bright directions of a smooth
     * surface, around a grain of dust, in the lone orders of a grating.
     */
    double expansion() {
        return 0.02 * value;
    }

    /** Relative error of an amplitude by interpolation; the power has twice that, and its weak spots more. */
    double interpolation() {
        return 0.15 * value;
    }

    /** Root mean square error, over the phases, of the powers that the ensemble's fields stand for. */
    double powers() {
        return 0.1 * value;
    }

    /** Relative error of the trapezoid rule over wavelengths for a lone order. */
    double wavelengths() {
        return value;
    }
}
