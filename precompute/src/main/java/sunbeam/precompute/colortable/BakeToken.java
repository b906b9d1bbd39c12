package sunbeam.precompute.colortable;

/** Progress and cancellation of a bake. Thread-safe. */
@FunctionalInterface
public interface BakeToken extends AutoCloseable {
    /** Shows no progress and never cancels. */
    BakeToken NONE = samples -> {};

    /**
     * Reports progress.
     *
     * @param samples number of samples done since the last call; 0 for a call that only tests for cancellation
     * @throws java.util.concurrent.CancellationException if the bake was cancelled
     */
    void step(long samples);

    @Override
    default void close() {}
}
