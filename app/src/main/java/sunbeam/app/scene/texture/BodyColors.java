package sunbeam.app.scene.texture;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import sunbeam.precompute.color.Srgb;

/** Color of a snake's body as a function of the place. */
interface BodyColors {

    /**
     * Returns the color at a place of the body: linear sRGB, each channel 0 to 1.
     *
     * @param along texture coordinate u, 0 at the snout, 1 at the tip of the tail
     * @param around angle from the middle of the back over pi: 0 on the back, -1 and 1 in the middle of the belly
     */
    Vector3dc at(double along, double around);

    /** Converts 0xRRGGBB to linear light, in which colors mix. */
    static Vector3dc ofSrgb(int rgb) {
        return new Vector3d(Srgb.linear(rgb >> 16 & 0xff), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff));
    }

    static double step(double from, double to, double value) {
        double t = Math.min(1, Math.max(0, (value - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }
}
