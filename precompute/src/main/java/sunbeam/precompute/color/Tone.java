package sunbeam.precompute.color;

/**
 * What becomes of light that is brighter than a screen, in linear sRGB, 1 being the screen's white; shaders/include/display.glsl has the
 * same.
 *
 * <p>Red, green and blue are scaled together, so that their ratios, the hue, stay: the largest of them, m, remains m up to s and becomes
 * 1 - (1 - s)^2 / (m + 1 - 2 s) above, which joins smoothly and reaches 1 nowhere. What is a hundred times brighter than white goes
 * towards white. The form is that of the Khronos PBR Neutral tone mapper (2024), with a start and a desaturation of our own, for the
 * colors of first orders are several times brighter than white and shall keep their saturation.
 */
public enum Tone {
    /** Compresses highlights from half of white on. */
    COMPRESS(0.5),

    /** Compresses nothing: each channel is cut at 1, as the thesis's program does, and highlights lose their hue. */
    CLIP(Float.MAX_VALUE);

    // A third of the saturation is gone at a hundred times white.
    private static final double DESATURATION = 0.005;
    // The last step but one of eight bits.
    private static final double BRIGHTEST_SHOWN = Srgb.linear(254);
    // Beyond, every color is white to a screen.
    private static final double BRIGHTEST = 1e9;

    private final double start;

    /** That holds unless chosen. */
    public static Tone of(boolean thesis) {
        return thesis ? CLIP : COMPRESS;
    }

    Tone(double start) {
        this.start = start;
    }

    /** The largest channel, s, up to which light is shown as it is. */
    public double start() {
        return start;
    }

    /**
     * The largest channel of what is shown with this one; of full white that of what is a little darker.
     *
     * @param shown 0 to 1
     */
    public double before(double shown) {
        if (shown <= start) {
            return shown;
        }
        double room = 1 - start;
        return room * room / (1 - Math.min(shown, BRIGHTEST_SHOWN)) - room + start;
    }

    /**
     * Brings linear sRGB into a screen's range.
     *
     * @param rgb three values from 0; replaced by values from 0 to 1
     */
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
        }
    }
}
