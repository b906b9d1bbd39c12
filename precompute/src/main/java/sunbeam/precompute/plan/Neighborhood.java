package sunbeam.precompute.plan;

import sunbeam.precompute.text.Text;

/**
 * The DFT bins that are summed around a frequency, (2 radiusX + 1) (2 radiusY + 1) of them.
 *
 * @param radiusX bins on each side along x
 * @param radiusY along y: a patch that is short there has them far apart
 * @param anchor the bin in the middle
 */
public record Neighborhood(int radiusX, int radiusY, Anchor anchor) {
    /** The largest radius that can be asked for. */
    public static final int MAXIMUM_RADIUS = 15;

    /** How the middle bin follows from the frequency. */
    public enum Anchor {
        /** The bin at or below it, as in the thesis. */
        FLOOR,
        /** The nearest bin. */
        NEAREST
    }

    /** As many bins along both axes. */
    public Neighborhood(int radius, Anchor anchor) {
        this(radius, radius, anchor);
    }

    /** How many are summed. */
    public long bins() {
        return (2L * radiusX + 1) * (2L * radiusY + 1);
    }

    String summary() {
        String middle = anchor == Anchor.FLOOR ? "floored" : "nearest";
        return Text.format("%d x %d bins around the %s one", 2 * radiusX + 1, 2 * radiusY + 1, middle);
    }

    /** Bins along x beyond the visible ones that are summed, and one more, because float32 may round into the next one. */
    int marginX() {
        return radiusX + 1;
    }

    int marginY() {
        return radiusY + 1;
    }

    /**
     * Steps of loops that one wavelength takes (shaders/method/neighborhood.glsl), with the one in which a driver finds each at its end:
     * those over a bin's terms are written out.
     */
    long loopSteps() {
        long rows = 2L * radiusY + 1;
        long columns = 2L * radiusX + 1;
        return 1 + (rows + 1) + rows * (columns + 1);
    }
}
