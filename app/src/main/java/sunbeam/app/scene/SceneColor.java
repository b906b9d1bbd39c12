package sunbeam.app.scene;

import java.util.regex.Pattern;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.text.Text;

/** Opaque sRGB color, 0xRRGGBB. */
public record SceneColor(int rgb) {
    private static final Pattern HEXADECIMAL = Pattern.compile("#[0-9a-fA-F]{6}");

    /** Throws IllegalArgumentException unless the text is {@code #rrggbb}; the message is for the user. */
    public static SceneColor parse(String text) {
        if (!HEXADECIMAL.matcher(text.strip()).matches()) {
            throw new IllegalArgumentException(
                    Text.quoted(text) + " is no color; write it as #rrggbb, such as #101418");
        }
        return new SceneColor(Integer.parseInt(text.strip().substring(1), 16));
    }

    /** Returns linear sRGB, 0 to 1. */
    public double[] light() {
        return new double[] {Srgb.linear(rgb >> 16), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff)};
    }

    @Override
    public String toString() {
        return Text.format("#%06x", rgb);
    }
}
