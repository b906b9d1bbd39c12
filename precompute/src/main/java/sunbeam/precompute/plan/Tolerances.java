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

    public static final double COARSEST = 1;
    public static final double STANDARD = 1e-3;

    /**
     * Root mean square error of the expansion over the surface. A weak order sees more of it than the mean, because what
     * is left out falls off more slowly with frequency than what is kept; more so the lone orders of a grating, whose
     * efficiencies differ by many powers of ten.
     */
    double expansion(Sampling sampling) {
        return (sampling instanceof Sampling.Grid ? 0.1 : 0.02) * value;
    }

    /** Relative error of an amplitude by interpolation; the power has twice that, and its weak spots more. */
    double interpolation() {
        return 0.25 * value;
    }

    /** Relative error of the trapezoid rule over wavelengths for a lone order. */
    double wavelengths() {
        return value;
    }
}
