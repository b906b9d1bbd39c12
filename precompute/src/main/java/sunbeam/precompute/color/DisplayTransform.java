package sunbeam.precompute.color;

/** Transform from linear CIE XYZ, times an exposure above 0, to display light: linear sRGB, gamut, tone (shaders/include/display.glsl). */
public record DisplayTransform(double exposure, Tone tone, Primaries primaries) {
    public DisplayTransform(double exposure, Tone tone) {
        this(exposure, tone, Primaries.SRGB);
    }

    /** Computes the linear sRGB display light, 0 to 1, of X, Y, Z before exposure; Y of 0 or below is black. */
    public void light(float[] xyz, int offset, double[] rgb) {
        light(xyz[offset], xyz[offset + 1], xyz[offset + 2], rgb);
    }

    private void light(double x, double y, double z, double[] rgb) {
        double luminance = exposure * y;
        if (!(luminance > 0 && luminance < Double.POSITIVE_INFINITY)) {
            rgb[0] = rgb[1] = rgb[2] = luminance > 0 ? 1 : 0;
            return;
        }
        primaries.channels(exposure * x, luminance, exposure * z, rgb);
        tone.apply(rgb);
    }

    /** Returns 0xRRGGBB of linear X, Y, Z before exposure, with the sRGB curve. */
    public int rgb(double[] xyz) {
        double[] light = new double[3];
        light(xyz[0], xyz[1], xyz[2], light);
        return packed(light);
    }

    /** Returns 0xRRGGBB of linear display light, from 0 to 1 in each channel. */
    public static int packed(double[] light) {
        return Srgb.channel(light[0]) << 16 | Srgb.channel(light[1]) << 8 | Srgb.channel(light[2]);
    }
}
