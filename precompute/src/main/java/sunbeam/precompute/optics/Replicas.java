package sunbeam.precompute.optics;

/** Numbers of repetitions of a patch, 1 to {@link #MOST}, in an evenly lit rectangle with sharp edges. */
public record Replicas(int alongX, int alongY) {
    /** With more, float32 does not resolve the orders. */
    public static final int MOST = 10_000;

    /** Returns the numbers whose lengths come closest to the coherence length along each axis, for sides in meters. */
    public static Replicas filling(CoherenceWindow window, double width, double height) {
        return new Replicas(count(window, width), count(window, height));
    }

    private static int count(CoherenceWindow window, double period) {
        return (int) Math.min(MOST, Math.max(1, Math.round(window.coherenceLength() / period)));
    }

    /** Returns the Gaussian window whose effective area, 4 pi sigma^2, is that of all replicas of a patch; lengths in meters. */
    public CoherenceWindow equalAreaWindow(double width, double height) {
        return new CoherenceWindow(Math.sqrt(alongX * width * alongY * height / (4 * Math.PI)));
    }
}
