package sunbeam.precompute.color;

/**
 * Tone mapping of light brighter than the screen's white (1), in linear sRGB. Red, green and blue are scaled together, which keeps the
 * hue: the largest of them, m, stays m up to s and becomes 1 - (1 - s)^2 / (m + 1 - 2 s) above. Colors much brighter than white lose
 * saturation. The form is that of the Khronos PBR Neutral tone mapper (2024); start and desaturation differ, since first orders are
 * several times brighter than white.
 */
public enum Tone {
    COMPRESS(0.5),

    /** Clips each channel at 1, as in the thesis. */
    CLIP(Float.MAX_VALUE),

    /** Clips and raises to 2.4 / 2.5, so that the exponent of sRGB's curve is 1 / 2.5, as in the thesis's program. */
    GAMMA(Float.MAX_VALUE);

    private static final double PROGRAM_GAMMA = 2.4 / 2.5;
    // Light at a hundred times white loses a third of its saturation.
    private static final double DESATURATION = 0.005;
    private static final double BRIGHTEST_SHOWN = Srgb.linear(254);
    // Largest input; brighter colors are white on any screen.
    private static final double BRIGHTEST = 1e9;

    private final double start;

    public static Tone of(boolean thesis) {
        return thesis ? CLIP : COMPRESS;
    }

    Tone(double start) {
        this.start = start;
    }

    /** Returns s, the largest channel value that is not compressed. */
    public double start() {
        return start;
    }

    /** Inverts the compression of the largest channel, 0 to 1; values above that of the 8-bit 254 count as it, since 1 has no inverse. */
    public double before(double shown) {
        if (this == GAMMA) {
            return Math.pow(shown, 1 / PROGRAM_GAMMA);
        }
        if (shown <= start) {
            return shown;
        }
        double room = 1 - start;
        return room * room / (1 - Math.min(shown, BRIGHTEST_SHOWN)) - room + start;
    }

    void apply(double[] rgb) {
        double largest = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
        if (largest > start) {
            double room = 1 - start;
            double bounded = Math.min(largest, BRIGHTEST);
            double compressed = 1 - room * room / (bounded + room - start);
            double white = 1 - 1 / (DESATURATION * (bounded - compressed) + 1);
            for (int c = 0; c < 3; c++) {
                double share = rgb[c] / largest;
                rgb[c] = compressed * (share + white * (1 - share));
            }
        }
        for (int c = 0; c < 3; c++) {
            rgb[c] = Math.min(1, rgb[c]);
            rgb[c] = this == GAMMA ? Math.pow(rgb[c], PROGRAM_GAMMA) : rgb[c];
        }
    }
}
