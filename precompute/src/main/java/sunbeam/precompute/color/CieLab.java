package sunbeam.precompute.color;

/**
 * Color in CIE 1976 L*a*b* (ISO/CIE 11664-4) with D65 as white.
 *
 * @param lightness L*, 100 for white, more for brighter colors
 * @param a a*, green to red
 * @param b b*, blue to yellow
 */
public record CieLab(double lightness, double a, double b) {
    /** X, Y, Z of D65 for the 2-degree observer (CIE 15:2018, table 3), Y = 1. */
    private static final double[] WHITE = {0.95047, 1, 1.08883};

    // Cube root of the ratio to white below which the response is linear.
    private static final double DELTA = 6.0 / 29;

    /** Converts linear X, Y, Z, with Y = 1 for white. */
    public static CieLab ofXyz(double x, double y, double z) {
        double fx = response(x / WHITE[0]);
        double fy = response(y / WHITE[1]);
        double fz = response(z / WHITE[2]);
        return new CieLab(116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz));
    }

    /** Converts an sRGB color 0xRRGGBB; higher bits are ignored. */
    public static CieLab ofSrgb(int rgb) {
        double[] xyz = Srgb.xyz(Srgb.linear(rgb >> 16 & 255), Srgb.linear(rgb >> 8 & 255), Srgb.linear(rgb & 255));
        return ofXyz(xyz[0], xyz[1], xyz[2]);
    }

    private static double response(double ratio) {
        return ratio > DELTA * DELTA * DELTA ? Math.cbrt(ratio) : ratio / (3 * DELTA * DELTA) + 4.0 / 29;
    }

    /** Returns C*, the distance from gray. */
    public double chroma() {
        return Math.hypot(a, b);
    }
}
