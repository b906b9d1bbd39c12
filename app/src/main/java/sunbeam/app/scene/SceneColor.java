package sunbeam.app.scene;

import java.util.Locale;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Quoted;

/**
 * An opaque colour, 8 bits a channel, sRGB.
 *
 * @param rgb 0xRRGGBB
 */
public record SceneColor(int rgb) {
    private static final Pattern HEXADECIMAL = Pattern.compile("#[0-9a-fA-F]{6}");
    // Linear sRGB to XYZ, IEC 61966-2-1; the inverse of the matrix in shaders/include/srgb.glsl.
    private static final double[][] TO_XYZ = {
        {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}
    };

    /** Rejects what does not fit in 24 bits. */
    public SceneColor {
        if (rgb < 0 || rgb > 0xffffff) {
            throw new IllegalArgumentException("not a colour of 24 bits: " + rgb);
        }
    }

    /**
     * From {@code #rrggbb}.
     *
     * @throws IllegalArgumentException for anything else, with a message for the user
     */
    public static SceneColor parse(String text) {
        if (!HEXADECIMAL.matcher(text.strip()).matches()) {
            throw new IllegalArgumentException(Quoted.of(text) + " is no colour; write it as #rrggbb, such as #101418");
        }
        return new SceneColor(Integer.parseInt(text.strip().substring(1), 16));
    }

    /** CIE XYZ of the colour, Y = 1 for white. */
    public double[] xyz() {
        double[] linear = {linear(rgb >> 16), linear(rgb >> 8 & 0xff), linear(rgb & 0xff)};
        double[] xyz = new double[3];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < 3; i++) {
                xyz[c] += TO_XYZ[c][i] * linear[i];
            }
        }
        return xyz;
    }

    private static double linear(int value) {
        double encoded = value / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /** As {@link #parse} reads it. */
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "#%06x", rgb);
    }
}
