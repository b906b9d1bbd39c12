package sunbeam.precompute.color;

import java.util.Locale;

/** What a screen shows of linear light: exposure, gamut and sRGB curve, as shaders/include/display.glsl has them. */
public final class DisplayColor {
    private static final double[][] FROM_XYZ = {
        {3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}
    };

    private DisplayColor() {}

    /** 0xRRGGBB of linear X, Y, Z after exposure: what is brighter than white is white, what no screen shows loses chroma. */
    public static int rgb(double[] xyz) {
        double luminance = xyz[1];
        if (!(luminance < 1)) {
            return Double.isNaN(luminance) ? 0 : 0xffffff;
        }
        double grey = Math.max(0, luminance);
        double[] chroma = new double[3];
        double keep = 1;
        for (int c = 0; c < 3; c++) {
            chroma[c] = FROM_XYZ[c][0] * xyz[0] + FROM_XYZ[c][1] * xyz[1] + FROM_XYZ[c][2] * xyz[2] - luminance;
            double room = chroma[c] > 0 ? 1 - grey : -grey;
            if (Math.abs(chroma[c]) > Math.abs(room)) {
                keep = Math.min(keep, room / chroma[c]);
            }
        }
        int rgb = 0;
        for (int c = 0; c < 3; c++) {
            rgb = rgb << 8 | Srgb.channel(grey + keep * chroma[c]);
        }
        return rgb;
    }

    /** As in a style sheet: {@code #1a2b3c}. */
    public static String hex(int rgb) {
        return String.format(Locale.ROOT, "#%06x", rgb);
    }
}
