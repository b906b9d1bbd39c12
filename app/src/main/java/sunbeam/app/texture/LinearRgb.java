package sunbeam.app.texture;

import sunbeam.precompute.color.Srgb;

/** A colour in linear sRGB, so that mixtures are those of light. */
record LinearRgb(double red, double green, double blue) {

    /** From 8-bit sRGB, 0xRRGGBB. */
    static LinearRgb ofSrgb(int rgb) {
        double[] linear = Srgb.linearOf(rgb);
        return new LinearRgb(linear[0], linear[1], linear[2]);
    }

    /** This at 0, the other at 1. */
    LinearRgb mix(LinearRgb other, double share) {
        return new LinearRgb(
                red + share * (other.red - red),
                green + share * (other.green - green),
                blue + share * (other.blue - blue));
    }

    LinearRgb times(double factor) {
        return new LinearRgb(factor * red, factor * green, factor * blue);
    }

    static byte encoded(double linear) {
        double clipped = Math.min(1, Math.max(0, linear));
        return (byte) Math.round(255 * Srgb.encoded(clipped));
    }
}
