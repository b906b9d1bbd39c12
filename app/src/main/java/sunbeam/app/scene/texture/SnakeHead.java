package sunbeam.app.scene.texture;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Eyes, mouth and shields of a snake's head: their colors over the skin's, and relief. */
public final class SnakeHead {
    /** Along the head: snout 0, neck 1. */
    public static final double EYE_ALONG = 0.27;

    /** Around the head: top 0, bottom 1. */
    public static final double EYE_AROUND = 0.32;

    // Half sizes, as shares of the head's length and half girth.
    private static final double EYE_LENGTH = 0.058;
    private static final double EYE_HEIGHT = 0.086;
    private static final Vector3dc PUPIL = BodyColors.ofSrgb(0x060505);
    // Across the top, snout 0 to neck 1; the frontal shield lies between the third and the fourth.
    private static final double[] SEAMS = {0.09, 0.17, 0.29, 0.5, 0.76};
    private static final double SEAM_WIDTH = 0.009;
    private static final double DARKEST_SEAM = 0.72;
    // In lengths of the head: a tenth of a millimeter each.
    private static final double GROOVE_DEPTH = 0.0022;
    private static final double ROUNDING = 0.002;
    // Edge of the top's shields and half width of the frontal one; top 0, bottom 1.
    private static final double TOP_EDGE = 0.27;
    private static final double FRONTAL_HALF_WIDTH = 0.1;
    // Line of the mouth and width of each lip; top 0, bottom 1.
    private static final double MOUTH = 0.62;
    private static final double LIP_WIDTH = 0.1;

    private final Vector3dc iris;

    SnakeHead(Vector3dc iris) {
        this.iris = iris;
    }

    /** Returns the color: {@code along} from snout 0 to neck 1, {@code side} from top 0 to bottom 1. */
    Vector3dc at(double along, double side, Vector3dc skin) {
        Vector3d color = skin.mul(1 - (1 - DARKEST_SEAM) * seam(along, side, 1), new Vector3d());
        double mouth = line(side - MOUTH + 0.07 * (along - 0.4) * (along - 0.4), 0.013)
                * (1 - BodyColors.step(0.6, 0.7, along));
        color.lerp(PUPIL, 0.85 * mouth);
        double x = (along - EYE_ALONG) / EYE_LENGTH;
        double y = (side - EYE_AROUND) / EYE_HEIGHT;
        double eye = Math.sqrt(x * x + y * y);
        color.lerp(PUPIL, 1 - BodyColors.step(1, 1.25, eye));
        color.lerp(iris, BodyColors.step(0.6, 0.68, eye) * (1 - BodyColors.step(0.82, 0.95, eye)));
        return color;
    }

    /**
     * Returns the height in lengths of the head; the shields' edges sink to the seams.
     *
     * @param along from snout 0 to neck 1
     * @param around top 0, bottom 1 and -1
     */
    static double height(double along, double around) {
        double side = Math.abs(around);
        return -GROOVE_DEPTH * seam(along, side, 2.2) - ROUNDING * seam(along, side, 6);
    }

    private static double seam(double along, double side, double widening) {
        double width = widening * SEAM_WIDTH;
        double seam = 0;
        for (double at : SEAMS) {
            seam = Math.max(
                    seam,
                    line(along - at - 0.12 * side * (0.5 - at), width)
                            * (1 - BodyColors.step(TOP_EDGE, TOP_EDGE + 0.03, side)));
        }
        boolean isFrontal = along > SEAMS[2] && along < SEAMS[3];
        double end = 1 - BodyColors.step(SEAMS[4], SEAMS[4] + 0.01, along);
        seam = Math.max(seam, end * line(side - (isFrontal ? FRONTAL_HALF_WIDTH : 0), 2 * width));
        seam = Math.max(seam, end * line(side - TOP_EDGE, 2 * width));
        double lip = BodyColors.step(MOUTH - LIP_WIDTH, MOUTH - LIP_WIDTH + 0.02, side)
                * (1 - BodyColors.step(MOUTH + LIP_WIDTH, MOUTH + LIP_WIDTH + 0.02, side));
        double shields = along / 0.085;
        return Math.max(seam, 0.7 * lip * line((shields - Math.rint(shields)) * 0.085, width));
    }

    private static double line(double distance, double width) {
        return 1 - BodyColors.step(0.3 * width, width, Math.abs(distance));
    }
}
