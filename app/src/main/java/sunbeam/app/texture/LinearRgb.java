package sunbeam.app.texture;

/** A colour in linear sRGB, so that mixtures are those of light. */
record LinearRgb(double red, double green, double blue) {

    /** From 8-bit sRGB, 0xRRGGBB. */
    static LinearRgb ofSrgb(int rgb) {
        return new LinearRgb(linear(rgb >> 16 & 0xff), linear(rgb >> 8 & 0xff), linear(rgb & 0xff));
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
        double curve = clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * Math.pow(clipped, 1 / 2.4) - 0.055;
        return (byte) Math.round(255 * curve);
    }

    private static double linear(int value) {
        double encoded = value / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }
}
