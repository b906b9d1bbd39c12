package sunbeam.precompute.colortable;

import sunbeam.precompute.work.Progress;

/** Evaluates colors of diffracted power, a batch of samples at a time. */
public interface ColorBaker extends AutoCloseable {
    int COLORS = 3;

    /** Most samples per batch: 50 MB of input, and as much output. */
    int LARGEST_BATCH = 1 << 22;

    /** Returns CIE X, Y, Z of the power at each u, v, w (at most 0); consecutive samples of one (u, v) share work. */
    float[] bake(float[] uvw, Progress token);

    /** Returns a baker of the same colors without interpolation between samples: slower, for validation. */
    default ColorBaker direct() {
        return this;
    }

    @Override
    default void close() {}
}
