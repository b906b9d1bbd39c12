package sunbeam.precompute.color;

/** Primaries of the linear RGB values that are sent to the screen. */
public enum Primaries {
    /** sRGB. Colors outside its gamut move towards the gray of their luminance. */
    SRGB,

    /** CIE 1931 RGB, as in the thesis's shader; on an sRGB screen its white is bluish. Negative channels are clipped. */
    CIE_RGB;

    // Inverse of the matrix whose columns are X, Y, Z of red, green and blue: (0.49, 0.17697, 0),
    // (0.31, 0.8124, 0.01) and (0.2, 0.01063, 0.99), each over 0.17697.
    private static final double[][] CIE_RGB_OF_XYZ = {
        {2.36461385, -0.89654057, -0.46807328},
        {-0.51516621, 1.42640810, 0.08875810},
        {0.00520370, -0.01440816, 1.00920446}
    };

    public static Primaries of(boolean thesis) {
        return thesis ? CIE_RGB : SRGB;
    }

    void channels(double x, double y, double z, double[] rgb) {
        if (this == CIE_RGB) {
            for (int c = 0; c < 3; c++) {
                double[] row = CIE_RGB_OF_XYZ[c];
                rgb[c] = Math.max(0, row[0] * x + row[1] * y + row[2] * z);
            }
            return;
        }
        for (int c = 0; c < 3; c++) {
            rgb[c] = Srgb.linear(c, x, y, z);
        }
        double least = Math.min(0, Math.min(rgb[0], Math.min(rgb[1], rgb[2])));
        double kept = y / (y - least);
        for (int c = 0; c < 3; c++) {
            rgb[c] = kept * (rgb[c] - least);
        }
    }
}
