package sunbeam.precompute.optics;

/**
 * Numbers of repetitions of a patch in an evenly lit rectangle with sharp edges.
 *
 * @param alongX at least 1
 * @param alongY at least 1
 */
public record Replicas(int alongX, int alongY) {
    /** Maximum number along an axis; with more, float32 does not resolve the orders. */
    public static final int MOST = 10_000;

    public Replicas {
        if (alongX < 1 || alongY < 1 || alongX > MOST || alongY > MOST) {
            throw new IllegalArgumentException("replicas " + alongX + " x " + alongY + " are not in 1.." + MOST);
        }
    }

    /**
     * Returns the numbers of replicas whose lengths come closest to the coherence length along each axis, for a patch of a width and height
     * in meters.
     */
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
