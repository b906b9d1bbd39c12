package sunbeam.precompute.analysis;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** What a surface's period means for its color, in one sentence for people: the first line of every command that looks for it. */
public final class Verdict {
    // Beyond, the eye sees too little to name a color.
    private static final double VIOLET = 400e-9;
    private static final double RED = 700e-9;
    private static final double FINEST_ANGLE = Math.sin(Math.toRadians(0.1));
    private static final double MICROMETRES = 1e6;
    private static final int DIGITS = 3;

    private Verdict() {}

    /**
     * "A grating of 1.08 um (1.03 to 1.13) across 87 degrees: first-order colors at 20 to 45 degrees".
     *
     * @param period of the same patch
     */
    public static String of(Patch patch, GratingPeriod period) {
        return of(patch, period, 0);
    }

    /**
     * The same under other light: "first-order colors at -9 to 11 degrees and from -58 degrees on under light at 30 degrees".
     *
     * @param theta of the light, degrees, in the plane across the lines; angles of colors are positive on its side
     */
    public static String of(Patch patch, GratingPeriod period, double theta) {
        if (patch.isMirror()) {
            return "A mirror: the relief is far below a wavelength, so that it has no color";
        }
        if (!period.isTold()) {
            String why = period.refusal().orElseThrow();
            return why.substring(0, 1).toUpperCase(Locale.ROOT) + why.substring(1);
        }
        String crossing = period.crossing()
                .map(other -> ", crossed by lines of about " + Lengths.rounded(other.period(), DIGITS) + across(other))
                .orElse("");
        return (period.isExact() ? "A repeated patch with a period of " : "A grating of ")
                + length(period.period(), period.low(), period.high())
                + across(period.wave())
                + crossing
                + ": "
                + colors(period.low(), period.high(), theta);
    }

    private static String across(SpatialFrequency wave) {
        return " across " + GratingPeriod.degrees(wave) + " degrees";
    }

    /**
     * "1.08 um (1.03 to 1.13)", or the period alone where it is exact.
     *
     * @param period metres
     * @param from lower end of its interval, metres
     * @param to upper end, metres
     */
    public static String length(double period, double from, double to) {
        double middle = MICROMETRES * period;
        double low = MICROMETRES * from;
        double high = MICROMETRES * to;
        double uncertainty = 0.5 * (high - low);
        return low == high
                ? Decimals.rounded(middle, DIGITS) + " um"
                : Decimals.within(middle, uncertainty) + " um (" + Decimals.within(low, uncertainty) + " to "
                        + Decimals.within(high, uncertainty) + ")";
    }

    /** Where the first orders go, sin theta = +-lambda / d - sin theta_i, whatever period of the interval is the true one. */
    private static String colors(double low, double high, double theta) {
        double mirror = -Math.sin(Math.toRadians(theta));
        double blue = VIOLET / high;
        double red = RED / low;
        String light = theta == 0 ? "light from above" : "light at " + Decimals.rounded(theta, DIGITS) + " degrees";
        if (blue - Math.abs(mirror) >= 1) {
            return "finer than light, so that " + light + " has no first-order colors";
        }
        if (red < FINEST_ANGLE) {
            return "no visible order can be resolved, all lie within 0.1 degrees of the mirror direction; check the width";
        }
        // Of light from above both are alike.
        String angles = DoubleStream.of(1, -1)
                .limit(theta == 0 ? 1 : 2)
                .filter(side -> Math.abs(mirror + side * blue) < 1)
                .mapToObj(side -> angles(mirror + side * blue, mirror + side * red))
                .collect(Collectors.joining(" and "));
        return "first-order colors " + angles + " under " + light;
    }

    private static String angles(double blue, double red) {
        return Math.abs(red) < 1
                ? Text.format("at %.0f to %.0f degrees", degrees(blue), degrees(red))
                : Text.format("from %.0f degrees on", degrees(blue));
    }

    /** In whole degrees, never -0. */
    private static double degrees(double sine) {
        return Math.rint(Math.toDegrees(Math.asin(sine))) + 0.0;
    }
}
