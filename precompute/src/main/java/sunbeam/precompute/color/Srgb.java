package sunbeam.precompute.color;

/** The colour space of screens and images, IEC 61966-2-1. */
public final class Srgb {
    // The inverse of the matrix in shaders/include/display.glsl.
    private static final double[][] TO_XYZ = {
        {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}
    };

    private Srgb() {}

    /** From linear light to the encoded value, both 0..1. */
    public static double encoded(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
    }

    /** From the encoded value to linear light, both 0..1. */
    public static double linear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /** Red, green and blue in linear light, 0..1, from 0xRRGGBB. */
    public static double[] linearOf(int rgb) {
        return new double[] {
            linear((rgb >> 16 & 0xff) / 255.0), linear((rgb >> 8 & 0xff) / 255.0), linear((rgb & 0xff) / 255.0)
        };
    }

    /** CIE XYZ, Y = 1 for white, of linear red, green and blue. */
    public static double[] xyz(double[] linear) {
        double[] xyz = new double[3];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < 3; i++) {
                xyz[c] += TO_XYZ[c][i] * linear[i];
            }
        }
        return xyz;
    }
}
