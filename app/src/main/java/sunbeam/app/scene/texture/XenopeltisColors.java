package sunbeam.app.scene.texture;

/**
 * A sunbeam snake (Xenopeltis unicolor): nearly black brown without any marking, so that nothing but diffraction colors
 * it; scales edged a little paler on the flanks, the belly pale.
 */
final class XenopeltisColors implements BodyColors {
    private static final LinearRgb BACK = LinearRgb.ofSrgb(0x33231b);
    private static final LinearRgb FLANK = LinearRgb.ofSrgb(0x4a3429);
    private static final LinearRgb BELLY = LinearRgb.ofSrgb(0xcdbfa8);

    private final SkinNoise grain = new SkinNoise(5, 1600, 120);
    private final SkinNoise mottle = new SkinNoise(6, 200, 12);

    @Override
    public LinearRgb at(double along, double around) {
        double side = Math.abs(around);
        LinearRgb skin = BACK.mix(FLANK, BodyColors.step(0.3, 0.7, side));
        double mottled = mottle.at(along, around);
        LinearRgb uneven = skin.times(1 + 0.12 * grain.at(along, around) + 0.12 * mottled);
        return uneven.mix(BELLY, BodyColors.step(0.72, 0.84, side + 0.03 * mottled));
    }
}
