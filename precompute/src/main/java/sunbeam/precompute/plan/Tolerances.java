package sunbeam.precompute.plan;

/** The tolerances that can be asked for. What each source of error may take of one: {@link ErrorBudget}. */
public final class Tolerances {
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

    private Tolerances() {}
}
