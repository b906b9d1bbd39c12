package sunbeam.precompute.plan;

import sunbeam.precompute.text.Text;

/** Bins that are summed around a frequency: 2 radius + 1 along each axis. */
public record Neighborhood(int radiusX, int radiusY, Anchor anchor) {
    public enum Anchor {
        /** Bin at or below the frequency, as in the thesis. */
        FLOOR,
        NEAREST
    }

    public Neighborhood(int radius, Anchor anchor) {
        this(radius, radius, anchor);
    }

    public long bins() {
        return (2L * radiusX + 1) * (2L * radiusY + 1);
    }

    String summary() {
        String middle = anchor == Anchor.FLOOR ? "floored" : "nearest";
        return Text.format("%d x %d bins around the %s one", 2 * radiusX + 1, 2 * radiusY + 1, middle);
    }

    /** Returns the loop steps of one wavelength (shaders/method/neighborhood.glsl), with the last test of each loop. */
    long loopSteps() {
        long rows = 2L * radiusY + 1;
        long columns = 2L * radiusX + 1;
        return 1 + (rows + 1) + rows * (columns + 1);
    }
}
