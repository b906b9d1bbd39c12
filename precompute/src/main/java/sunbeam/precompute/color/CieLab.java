package sunbeam.precompute.color;

/** Color in CIE 1976 L*a*b* (ISO/CIE 11664-4) with D65 as white, of lightness 100; brighter colors have more. */
public record CieLab(double lightness, double a, double b) {
    /** X, Y, Z of D65 for the 2-degree observer (CIE 15:2018, table 3), Y = 1. */
    private static final double[] WHITE = {0.95047, 1, 1.08883};
    // Cube root of the ratio to white below which the response is linear.
    private static final double DELTA = 6.0 / 29;
    private static final double POWER_25_TO_7 = Math.pow(25, 7);

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

    public double chroma() {
        return Math.hypot(a, b);
    }

    /** Returns the hue angle h_ab, degrees in 0..360. */
    public double hue() {
        return hue(a, b);
    }

    /**
     * Returns CIEDE2000 (ISO/CIE 11664-6) with all weights 1, at least 0; a difference of about 1 is just visible. Numbers below are
     * equations of G. Sharma, W. Wu, E. Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test data, and
     * mathematical observations", Color Research and Application 30 (2005).
     */
    public double difference(CieLab other) {
        double stretch = stretch(0.5 * (chroma() + other.chroma()));
        double a1 = stretch * a;
        double a2 = stretch * other.a();
        double c1 = Math.hypot(a1, b);
        double c2 = Math.hypot(a2, other.b());
        double h1 = hue(a1, b);
        double h2 = hue(a2, other.b());
        boolean gray = c1 * c2 == 0;
        double hueStep = gray ? 0 : Math.IEEEremainder(h2 - h1, 360);

        // (8), (9), (11)
        double lightnessDifference = other.lightness() - lightness;
        double chromaDifference = c2 - c1;
        double hueDifference = 2 * Math.sqrt(c1 * c2) * Math.sin(Math.toRadians(0.5 * hueStep));
        // (12) to (14); the mean hue lies midway on the shorter arc.
        double meanLightness = 0.5 * (lightness + other.lightness());
        double chroma = 0.5 * (c1 + c2);
        double hue = gray ? h1 + h2 : within360(h1 + 0.5 * hueStep);

        double chromaTerm = chromaDifference / (1 + 0.045 * chroma);
        double hueTerm = hueDifference / hueScale(chroma, hue);
        return Math.sqrt(square(lightnessDifference / lightnessScale(meanLightness))
                + square(chromaTerm)
                + square(hueTerm)
                + rotation(chroma, hue) * chromaTerm * hueTerm);
    }

    /** 1 + G, (4) and (5): factor of a*, largest near gray. */
    private static double stretch(double meanChroma) {
        return 1.5 - 0.5 * chromaFactor(meanChroma);
    }

    /** Factor of equations (4) and (21): 0 for gray, towards 1 for high chroma. */
    private static double chromaFactor(double chroma) {
        double power = Math.pow(chroma, 7);
        return Math.sqrt(power / (power + POWER_25_TO_7));
    }

    /** Degrees in 0..360, (7). */
    private static double hue(double a, double b) {
        return a == 0 && b == 0 ? 0 : within360(Math.toDegrees(Math.atan2(b, a)));
    }

    private static double within360(double degrees) {
        return degrees < 0 ? degrees + 360 : degrees >= 360 ? degrees - 360 : degrees;
    }

    /** S_L, (16). */
    private static double lightnessScale(double lightness) {
        double fromMiddle = square(lightness - 50);
        return 1 + 0.015 * fromMiddle / Math.sqrt(20 + fromMiddle);
    }

    /** S_H with T, (15) and (18). */
    private static double hueScale(double chroma, double hue) {
        double t = 1
                - 0.17 * cosine(hue - 30)
                + 0.24 * cosine(2 * hue)
                + 0.32 * cosine(3 * hue + 6)
                - 0.20 * cosine(4 * hue - 63);
        return 1 + 0.015 * chroma * t;
    }

    /** R_T, (19) to (21): term for the tilted ellipses of equal difference in blue. */
    private static double rotation(double chroma, double hue) {
        double degrees = 30 * Math.exp(-square((hue - 275) / 25));
        return -2 * chromaFactor(chroma) * Math.sin(Math.toRadians(2 * degrees));
    }

    private static double cosine(double degrees) {
        return Math.cos(Math.toRadians(degrees));
    }

    private static double square(double value) {
        return value * value;
    }
}
