package sunbeam.precompute.colortable;

/** Evaluates colors of diffracted power, a batch of samples at a time. */
public interface ColorBaker extends AutoCloseable {
    /** Most samples per batch: 50 MB of input, and as much output. */
    int LARGEST_BATCH = 1 << 22;

    /**
     * Evaluates a batch.
     *
     * @param uvw u, v and w of each sample, w at most 0. Consecutive samples of one (u, v) share work
     * @return CIE X, Y, Z of each sample's power
     */
    float[] bake(float[] uvw, BakeToken token);

    /** Returns a baker of the same colors without interpolation between samples: slower, for validation. */
    default ColorBaker direct() {
        return this;
    }

    @Override
    default void close() {}
}
