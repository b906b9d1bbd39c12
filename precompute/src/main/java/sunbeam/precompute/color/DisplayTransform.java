package sunbeam.precompute.color;

/**
 * From linear CIE XYZ to the light that a screen shows: exposure, linear sRGB, gamut, tone. The one definition for maps, pictures of
 * scenes, the viewer and {@code color}; shaders/include/display.glsl has the same for pictures that move.
 *
 * @param exposure factor of XYZ, above 0
 * @param tone what becomes of highlights
 * @param primaries that colors are written in
 */
public record DisplayTransform(double exposure, Tone tone, Primaries primaries) {
    /** With a screen's own primaries. */
    public DisplayTransform(double exposure, Tone tone) {
        this(exposure, tone, Primaries.SRGB);
    }

    /**
     * Linear sRGB of a color as a screen shows it.
     *
     * @param xyz from {@code offset} on: X, Y, Z before exposure; black where Y is not above 0
     * @param rgb the result, three values from 0 to 1
     */
    public void light(float[] xyz, int offset, double[] rgb) {
        light(xyz[offset], xyz[offset + 1], xyz[offset + 2], rgb);
    }

    private void light(double x, double y, double z, double[] rgb) {
        double luminance = exposure * y;
        if (!(luminance > 0)) {
            rgb[0] = rgb[1] = rgb[2] = 0;
            return;
        }
        if (luminance == Double.POSITIVE_INFINITY) {
            rgb[0] = rgb[1] = rgb[2] = 1;
            return;
        }
        primaries.channels(exposure * x, luminance, exposure * z, rgb);
        tone.apply(rgb);
    }

    /** 0xRRGGBB of linear X, Y, Z before exposure, through the sRGB curve. */
    public int rgb(double[] xyz) {
        double[] light = new double[3];
        light(xyz[0], xyz[1], xyz[2], light);
        return packed(light);
    }

    /** 0xRRGGBB of a screen's linear light, from 0 to 1 in each channel. */
    public static int packed(double[] light) {
        return Srgb.channel(light[0]) << 16 | Srgb.channel(light[1]) << 8 | Srgb.channel(light[2]);
    }
}
