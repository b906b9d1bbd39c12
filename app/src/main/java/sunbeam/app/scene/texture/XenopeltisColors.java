package sunbeam.app.scene.texture;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A sunbeam snake (Xenopeltis unicolor): nearly black brown without markings, so that only diffraction colors it; paler flanks, a pale
 * belly and pale lips. {@link ScaleRelief} has the pale scales above the belly.
 */
final class XenopeltisColors implements BodyColors {
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
