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

    /**
     * A sunbeam snake (Xenopeltis unicolor): nearly black brown without markings, so that only diffraction colors it; paler flanks, a pale
     * belly and pale lips. {@link ScaleRelief} has the pale scales above the belly.
     */
    final class Xenopeltis implements BodyColors {
        private static final Vector3dc BACK = BodyColors.ofSrgb(0x33231b);
        private static final Vector3dc FLANK = BodyColors.ofSrgb(0x4a3429);
        private static final Vector3dc BELLY = BodyColors.ofSrgb(0xcdbfa8);

        private final SnakeHead head = new SnakeHead(BodyColors.ofSrgb(0x3a2a1c));
        private final SkinNoise grain = new SkinNoise(5, 1600, 120);
        private final SkinNoise mottle = new SkinNoise(6, 200, 12);

        @Override
        public Vector3dc at(double along, double around) {
            double side = Math.abs(around);
            Vector3dc skin = BACK.lerp(FLANK, BodyColors.step(0.3, 0.7, side), new Vector3d());
            double mottled = mottle.at(along, around);
            Vector3dc uneven = skin.mul(1 + 0.12 * grain.at(along, around) + 0.12 * mottled, new Vector3d());
            // The upper lip is pale; behind the head the edge sinks to that of the belly's shields.
            double edge = 0.52 + 0.2 * BodyColors.step(0.6, 1, along / ScaleRelief.BEGIN);
            Vector3dc pale = uneven.lerp(BELLY, BodyColors.step(edge, edge + 0.04, side), new Vector3d());
            return along < ScaleRelief.BEGIN ? head.at(along / ScaleRelief.BEGIN, side, pale) : pale;
        }
    }
}
