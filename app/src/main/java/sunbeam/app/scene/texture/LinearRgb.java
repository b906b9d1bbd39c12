package sunbeam.app.scene.texture;

import sunbeam.precompute.color.Srgb;

/** A color in linear sRGB, so that mixtures are those of light. */
record LinearRgb(double red, double green, double blue) {

    /** From 8-bit sRGB, 0xRRGGBB. */
    static LinearRgb ofSrgb(int rgb) {
        return new LinearRgb(Srgb.linear(rgb >> 16 & 0xff), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff));
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

    /** As {@link Srgb#channel}, without a power: a texture has millions of these. */
    static byte encoded(double linear) {
        return (byte) Srgb.channel(linear);
    }
}
