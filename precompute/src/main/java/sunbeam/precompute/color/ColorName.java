package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.Locale;

/** Everyday name of a color: ranges of CIELAB's lightness, chroma and hue angle (degrees). The first constant that fits names it. */
@SuppressWarnings("ImmutableEnumChecker") // ranges are records of numbers
public enum ColorName {
    BLACK(range(0, 14), Range.DULL, Range.ALL),
    DARK_GRAY(range(14, 40), Range.DULL, Range.ALL),
    GRAY(range(40, 85), Range.DULL, Range.ALL),
    WHITE(Range.ALL, Range.DULL, Range.ALL),
    BROWN(range(0, 60), range(12, 45), range(35, 95)),
    RED(range(350, 50), range(600, 780)),
    ORANGE(range(50, 82), range(582, 600)),
    YELLOW(range(82, 112), range(562, 582)),
    GREEN(range(112, 175), range(505, 562)),
    TURQUOISE(range(175, 235), range(485, 505)),
    BLUE(range(235, 308), range(440, 485)),
    VIOLET(range(308, 322), range(380, 440)),
    PURPLE(Range.ALL, Range.ALL, range(322, 350));

    private final Range lightness;
    private final Range chroma;
    private final Range hue;
    // Wavelengths that show the color, nanometers; those of a color that is not of the spectrum are infinitely far.
    private final Range spectrum;

    ColorName(Range lightness, Range chroma, Range hue) {
        this(lightness, chroma, hue, range(1e18, 1e18));
    }

    ColorName(Range hue, Range spectrum) {
        this(Range.ALL, Range.ALL, hue, spectrum);
    }

    ColorName(Range lightness, Range chroma, Range hue, Range spectrum) {
        this.lightness = lightness;
        this.chroma = chroma;
        this.hue = hue;
        this.spectrum = spectrum;
    }

    /** Range from a number up to but without another; one of angles may pass 360. */
    private record Range(double from, double to) {
        private static final Range ALL = new Range(0, 1e9);
        private static final Range DULL = new Range(0, 12);

        boolean has(double value) {
            return from < to ? value >= from && value < to : value >= from || value < to;
        }
    }

    private static Range range(double from, double to) {
        return new Range(from, to);
    }

    public static ColorName of(CieLab color) {
        return Arrays.stream(values())
                .filter(name -> name.lightness.has(Math.max(0, color.lightness()))
                        && name.chroma.has(color.chroma())
                        && name.hue.has(color.hue()))
                .findFirst()
                .orElseThrow();
    }

    public String words() {
        return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    /** Returns the distance of a wavelength from those that show this color, meters. */
    public double distance(double wavelength) {
        double nm = 1e9 * wavelength;
        return 1e-9 * Math.max(0, Math.max(spectrum.from - nm, nm - spectrum.to));
    }
}
