package sunbeam.precompute.color;

import java.util.Locale;

/** Colors as diagrams show them. */
public final class DisplayColor {
    private static final double[][] FROM_XYZ = {
        {3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}
    };

    private DisplayColor() {}

    /**
     * A colour as a screen can show it with its hue and as much of its saturation as there is: for diagrams of colours,
     * where what is too bright shall not become white.
     *
     * @param rgb 0xRRGGBB
     * @param tooBright whether it is brighter than the screen shows this hue, and drawn darker
     * @param tooPure whether it is purer than any colour of sRGB, and drawn less saturated
     */
    public record Hued(int rgb, boolean tooBright, boolean tooPure) {
        // Less of its saturation lost is less than a screen's smallest step.
        private static final double SEEN = 0.995;

        /** Of linear X, Y, Z after exposure; black for what is black or no number. */
        public static Hued of(double[] xyz) {
            return of(xyz, 1);
        }

        /** As bright as a screen shows it: the same at all exposures. */
        public static Hued brightest(double[] xyz) {
            return of(xyz, Double.POSITIVE_INFINITY);
        }

        /** @param largestScale of the luminance */
        private static Hued of(double[] xyz, double largestScale) {
            double luminance = xyz[1];
            if (!(luminance > 0)) {
                return new Hued(0, false, false);
            }
            double[] chroma = new double[3];
            double keep = 1;
            double largest = 0;
            for (int c = 0; c < 3; c++) {
                chroma[c] = FROM_XYZ[c][0] * xyz[0] + FROM_XYZ[c][1] * xyz[1] + FROM_XYZ[c][2] * xyz[2] - luminance;
                keep = chroma[c] < -luminance ? Math.min(keep, -luminance / chroma[c]) : keep;
                largest = Math.max(largest, chroma[c]);
            }
            double fitting = 1 / (luminance + keep * largest);
            double scale = Math.min(largestScale, fitting);
            int rgb = 0;
            for (double value : chroma) {
                rgb = rgb << 8 | Srgb.channel(scale * (luminance + keep * value));
            }
            return new Hued(rgb, Double.isFinite(largestScale) && fitting < SEEN, keep < SEEN);
        }

        /** As in a style sheet: {@code #1a2b3c}. */
        public String hex() {
            return DisplayColor.hex(rgb);
        }
    }

    /** As in a style sheet: {@code #1a2b3c}. */
    public static String hex(int rgb) {
        return String.format(Locale.ROOT, "#%06x", rgb);
    }
}
