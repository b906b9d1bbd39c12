package sunbeam.precompute.colortable;

/** Evaluates colors of diffracted power, a batch of samples at a time. */
public interface ColorBaker extends AutoCloseable {
    /** Most samples per batch: 50 MB of input, and as much output. */
    int LARGEST_BATCH = 1 << 22;

    /** Progress and cancellation of a bake. Thread-safe. */
    @FunctionalInterface
    interface Token extends AutoCloseable {
        /** Shows no progress and never cancels. */
        Token NONE = samples -> {};

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

    /**
     * Evaluates a batch.
     *
     * @param uvw u, v and w of each sample, w at most 0. Consecutive samples of one (u, v) share work
     * @return CIE X, Y, Z of each sample's power
     */
    float[] bake(float[] uvw, Token token);

    /** Returns a baker of the same colors without interpolation between samples: slower, for validation. */
    default ColorBaker direct() {
        return this;
    }

    @Override
    default void close() {}
}
