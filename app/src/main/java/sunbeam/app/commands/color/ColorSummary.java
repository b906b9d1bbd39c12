package sunbeam.app.commands.color;

import java.util.Locale;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.DisplayColor;
import sunbeam.precompute.units.Lengths;

/** What is told of a surface in a few lines. */
final class ColorSummary {
    /** Degrees to either side that hold every axis. */
    private static final double ANY_DIRECTION = 90;

    private ColorSummary() {}

    /** Lines for standard output. */
    static String of(ColorReport report) {
        String start = report.name() + ": " + direction(report.direction()) + "; ";
        return start + report.purest().map(ColorSummary::purest).orElseGet(() -> nothing(report));
    }

    /** Where along lies, and whether the scan tells it. */
    static String direction(PrincipalDirection direction) {
        return direction.halfWidthDegrees().orElse(0) < ANY_DIRECTION
                ? "direction of most colour at azimuth " + direction.describe()
                : String.format(
                        Locale.ROOT,
                        "the scan tells no direction of most colour, along is drawn at azimuth %.0f degrees",
                        direction.azimuthDegrees());
    }

    private static String purest(ColorReport.Purest purest) {
        SeenColor colour = purest.colour();
        String seen = String.format(
                Locale.ROOT,
                "purest colour at %s: %s, hue of %s%n",
                angle(colour.view().thetaRDegrees()),
                hue(colour.hue()),
                shown(DisplayColor.Hued.brightest(colour.xyz())));
        String shown = String.format(
                Locale.ROOT,
                "  at this exposure %s, chroma %.0f +- %.2g by computation (another spot of the surface differs by more)%n",
                shown(colour.shown()),
                colour.lab().chroma(),
                colour.uncertainty().chroma());
        SpectralWidth width = purest.width();
        String spectrum = String.format(
                Locale.ROOT,
                "  its spectrum is highest at %.0f nm and %s%s nm wide at half of that, half of its light within %.0f to %.0f"
                        + " nm; the coherence length alone makes an order %s nm wide",
                1e9 * width.peak(),
                width.whole() ? "" : "more than ",
                nanometres(width.width()),
                1e9 * width.from(),
                1e9 * width.to(),
                nanometres(purest.windowWidth()));
        return seen + shown + spectrum;
    }

    /** Where a maximum lies, and whether the range of angles ends there. */
    static String angle(double degrees) {
        return String.format(
                Locale.ROOT,
                Math.abs(degrees) < ColorStrips.LARGEST_VIEW_DEGREES
                        ? "%.0f degrees"
                        : "%.0f degrees (the last one that was tried; it may be purer beyond)",
                degrees);
    }

    private static String nanometres(double metres) {
        double value = 1e9 * metres;
        return String.format(Locale.ROOT, value < 10 ? "%.2g" : "%.0f", value);
    }

    /** A screen's colour, and what it leaves out. */
    private static String shown(DisplayColor.Hued colour) {
        if (!colour.tooBright() && !colour.tooPure()) {
            return colour.hex();
        }
        String lost = colour.tooBright() ? "brighter" + (colour.tooPure() ? " and purer" : "") : "purer";
        return colour.hex() + " (clipped: it is " + lost + " than a screen shows)";
    }

    private static String hue(Chromaticity.Hue hue) {
        double wavelength = hue.nanometres();
        if (Double.isNaN(wavelength)) {
            return "no hue";
        }
        return String.format(
                Locale.ROOT,
                wavelength > 0
                        ? "dominant wavelength %.0f nm, purity %.2f"
                        : "purple, complement of %.0f nm, purity %.2f",
                Math.abs(wavelength),
                hue.purity());
    }

    private static String nothing(ColorReport report) {
        if (report.isAllMirror()) {
            return String.format(
                    Locale.ROOT,
                    "no order to tell the colour of: with a coherence length of %s each is %.0f nm wide or more and lies in"
                            + " the mirror's light",
                    Lengths.rounded(report.coherenceLength(), 4),
                    1e9 * report.narrowestOrder());
        }
        return "no order to tell the colour of: along it no light, or none but the mirror's";
    }
}
