package sunbeam.precompute.patch.builtin;

/** Checks that all generators share. */
final class Parameters {
    /** Largest side: 16,384 squared heights take 2 GiB. */
    private static final int MOST_SAMPLES = 16_384;

    private Parameters() {}

    static void requirePositive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException(name + " must be positive and finite, got " + value);
        }
    }

    static void requireSamples(String name, int value, int least) {
        if (value < least || value > MOST_SAMPLES) {
            throw new IllegalArgumentException(name + " must be " + least + " to " + MOST_SAMPLES + ", got " + value);
        }
    }
}
