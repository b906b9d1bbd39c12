package sunbeam.precompute.plan;

import sunbeam.precompute.text.Text;

/**
 * Bins that are summed around a frequency, (2 radiusX + 1) (2 radiusY + 1) of them.
 *
 * @param radiusX bins on each side along x
 * @param radiusY bins on each side along y, where a short patch has them farther apart
 * @param anchor bin in the middle
 */
public record Neighborhood(int radiusX, int radiusY, Anchor anchor) {
    /** Largest radius of the setting. */
    public static final int MAXIMUM_RADIUS = 15;

    /** Rule for the middle bin. */
    public enum Anchor {
        /** Bin at or below the frequency, as in the thesis. */
        FLOOR,
        NEAREST
    }

    public Neighborhood(int radius, Anchor anchor) {
        this(radius, radius, anchor);
    }

    /** Returns the number of bins. */
    public long bins() {
        return (2L * radiusX + 1) * (2L * radiusY + 1);
    }

    String summary() {
        String middle = anchor == Anchor.FLOOR ? "floored" : "nearest";
        return Text.format("%d x %d bins around the %s one", 2 * radiusX + 1, 2 * radiusY + 1, middle);
    }

    /** Returns the bins needed beyond the visible ones along x: the radius, and one since float32 may round into the next bin. */
    int marginX() {
        return radiusX + 1;
    }

    int marginY() {
        return radiusY + 1;
    }

    /**
     * Returns the loop steps of one wavelength (shaders/method/neighborhood.glsl), with the step that ends each loop; loops over terms are
     * unrolled.
     */
    long loopSteps() {
        long rows = 2L * radiusY + 1;
        long columns = 2L * radiusX + 1;
        return 1 + (rows + 1) + rows * (columns + 1);
    }
}
