package sunbeam.precompute.work;

/** Progress and cancellation of a task, which closes it at its end. Thread-safe. */
@FunctionalInterface
public interface Progress extends AutoCloseable {
    Progress NONE = steps -> {};

    /**
     * Reports progress; throws CancellationException if the task was cancelled.
     *
     * @param steps number done since the last call; 0 only tests for cancellation
     */
    void step(long steps);

    @Override
    default void close() {}
}
