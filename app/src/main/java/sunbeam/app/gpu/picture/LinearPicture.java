package sunbeam.app.gpu.picture;

/**
 * Linear CIE XYZ per pixel; NaN where there is no surface.
 *
 * @param xyz {@code height * width * 3} values, row 0 on top
 */
public record LinearPicture(int width, int height, float[] xyz) {

    /** From RGBA as a render target gives it; what has alpha 0 is no surface. */
    public static LinearPicture ofRgba(int width, int height, float[] rgba) {
        float[] xyz = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            boolean covered = rgba[4 * i + 3] > 0;
            for (int c = 0; c < 3; c++) {
                xyz[3 * i + c] = covered ? rgba[4 * i + c] : Float.NaN;
            }
        }
        return new LinearPicture(width, height, xyz);
    }

    /** Whether a pixel shows the surface. */
    public boolean covered(int pixel) {
        return !Float.isNaN(xyz[3 * pixel + 1]);
    }

    /** Luminance Y of a pixel. */
    public float luminance(int pixel) {
        return xyz[3 * pixel + 1];
    }
}
