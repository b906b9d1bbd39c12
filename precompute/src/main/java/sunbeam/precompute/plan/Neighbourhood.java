package sunbeam.precompute.plan;

/**
 * The DFT bins that are summed around a frequency, (2 radius + 1)^2 of them.
 *
 * @param radius bins on each side, 0..64
 * @param anchor the bin in the middle
 */
public record Neighbourhood(int radius, Anchor anchor) {
    /** The largest radius that can be asked for; beyond it a window this narrow wants other means. */
    public static final int MAXIMUM_RADIUS = 15;

    /** The largest radius that is ever summed: for single wavelengths, where time is no matter. */
    public static final int LARGEST_SUM = 64;

    /** How the middle bin follows from the frequency. */
    public enum Anchor {
        /** The bin at or below it, as in the thesis. */
        FLOOR,
        /** The nearest bin. */
        NEAREST
    }

    public Neighbourhood {
        if (radius < 0 || radius > LARGEST_SUM) {
            throw new IllegalArgumentException("radius " + radius + " is not in 0.." + LARGEST_SUM);
        }
    }

    /** Bins along each axis. */
    private int side() {
        return 2 * radius + 1;
    }

    /** In a few words. */
    String summary() {
        String middle = anchor == Anchor.FLOOR ? "floored" : "nearest";
        return side() + " x " + side() + " bins around the " + middle + " one";
    }

    /** Bins beyond the visible ones that are summed, and one more, because float32 may round into the next one. */
    int margin() {
        return radius + 1;
    }

    /** Texture reads of all bins. */
    long reads(int terms) {
        return (long) side() * side() * terms;
    }
}
