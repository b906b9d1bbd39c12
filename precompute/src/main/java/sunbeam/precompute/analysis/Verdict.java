package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Effect of a surface's period on its color: a code, a sentence without full stop, a band per first order. */
public record Verdict(Code code, String sentence, List<Band> firstOrders) {
    /** Angles of 400 and 700 nm for all periods in the interval; degrees, positive on the light's side, 90 or -90 beyond the horizon. */
    public record Band(double blue, double red) {}

    /** Kinds of surfaces (docs/evaluation.md). */
    public enum Code {
        SURE_GRATING,
        PROBABLE_GRATING,
        LATTICE,
        PROBABLE_LATTICE,
        ALL_DIRECTIONS,
        FINER_THAN_LIGHT,
        NONE,
        TOO_LITTLE,
        MIRROR;

        public String label() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Meters; wavelengths at which the eye sees enough to name a color. */
    public static final double VIOLET = 400e-9;

    public static final double RED = 700e-9;
    // Sine of the smallest resolved angle to the mirror direction.
    private static final double FINEST_ANGLE = Math.sin(Math.toRadians(0.1));
    private static final double MICROMETERS_PER_METER = 1e6;
    private static final int DIGITS = 3;
    // Degrees; narrower bands of color have angles with a decimal.
    private static final double NARROW = 2;
    // Sine of 4 degrees: a scanner's axes differ in scale and angle.
    private static final double SLANT = 0.07;

    /** Light at theta to the normal and azimuth phi to the wave, degrees: "A grating ...: first-order colors at -9 to 11 degrees ...". */
    public static Verdict of(Patch patch, GratingPeriod period, double theta, double phi) {
        if (patch.isMirror()) {
            return new Verdict(
                    Code.MIRROR, "A mirror: the relief is far below a wavelength, so that it has no color", List.of());
        }
        if (!period.isSeen()) {
            String why = period.reason();
            return new Verdict(
                    code(period), why.substring(0, 1).toUpperCase(Locale.ROOT) + why.substring(1), List.of());
        }
        boolean lattice = period.isLattice();
        double along = Math.sin(Math.toRadians(theta)) * Math.cos(Math.toRadians(phi));
        // Orders keep the light's component along the lines.
        double horizon = Math.cos(Math.asin(Math.sin(Math.toRadians(theta)) * Math.sin(Math.toRadians(phi))));
        List<Band> firstOrders = firstOrders(period, -along, horizon);
        return new Verdict(
                firstOrders.isEmpty() ? Code.FINER_THAN_LIGHT : code(period),
                (lattice ? lattice(period) : grating(period)) + ": " + colors(period, theta, phi, firstOrders),
                firstOrders);
    }

    public boolean hasColor() {
        return switch (code) {
            case SURE_GRATING, PROBABLE_GRATING, LATTICE, PROBABLE_LATTICE, ALL_DIRECTIONS -> true;
            case FINER_THAN_LIGHT, NONE, TOO_LITTLE, MIRROR -> false;
        };
    }

    private static Code code(GratingPeriod period) {
        return switch (period.certainty()) {
            case SURE -> period.isLattice() ? Code.LATTICE : Code.SURE_GRATING;
            case PROBABLE -> period.isLattice() ? Code.PROBABLE_LATTICE : Code.PROBABLE_GRATING;
            case ALL_DIRECTIONS -> Code.ALL_DIRECTIONS;
            case TOO_LITTLE -> Code.TOO_LITTLE;
            case NONE -> Code.NONE;
        };
    }

    private static String grating(GratingPeriod period) {
        String crossing = period.others().stream()
                .map(other -> (other.sineTo(period.wave()) < SLANT ? ", overlaid" : ", crossed") + " by lines of about "
                        + Lengths.rounded(other.period(), DIGITS)
                        + (period.hasDirection() ? " across " + GratingPeriod.direction(other) : ""))
                .collect(Collectors.joining());
        String kind = !period.isSure()
                ? "Probably a grating of about "
                : period.isExact() ? "A repeated patch with a period of " : "A grating of ";
        String where =
                period.hasDirection() ? "across " + GratingPeriod.direction(period.wave()) : period.unknownDirection();
        return kind + length(period, 1, 1, 1) + " " + where + crossing;
    }

    /** "A hexagonal lattice with a constant of 0.900 um (0.898 to 0.901), its lines 0.779 um apart across -86 and 34 degrees". */
    private static String lattice(GratingPeriod period) {
        double sine = period.wave().sineTo(period.others().get(0));
        boolean hexagonal = Math.abs(sine - Math.sqrt(0.75)) < SLANT;
        String kind = hexagonal ? "hexagonal" : sine > 1 - SLANT * SLANT ? "square" : "rhombic";
        List<Long> directions = period.directions();
        int last = directions.size() - 1;
        String first = directions.stream().limit(last).map(String::valueOf).collect(Collectors.joining(", "));
        double angle = Math.asin(Math.min(1, sine));
        double turn = Math.sqrt(2) * period.azimuthHalfWidth();
        double least = 1 / Math.sin(Math.min(0.5 * Math.PI, angle + turn));
        double most = angle > turn ? 1 / Math.sin(angle - turn) : Double.POSITIVE_INFINITY;
        String constant = length(period, 1 / sine, least, most);
        return (period.isSure() ? "A " : "Probably a ") + kind + " lattice with a constant of "
                + (period.isSure() ? "" : "about ") + constant + ", its lines "
                + Lengths.rounded(period.period(), DIGITS) + " apart across " + first + " and "
                + directions.get(last) + " degrees";
    }

    /** "1.08 um (1.03 to 1.13)", "1.08 um" if exact, "2.9 um (3.4 periods seen, ...)" if probable. */
    private static String length(GratingPeriod period, double factor, double least, double most) {
        if (!period.isSure()) {
            return Lengths.rounded(factor * period.period(), 2) + " (" + period.reason() + ")";
        }
        double middle = factor * MICROMETERS_PER_METER * period.period();
        double low = least * MICROMETERS_PER_METER * period.low();
        double high = most * MICROMETERS_PER_METER * period.high();
        double uncertainty = 0.5 * ((Double.isFinite(high) ? high : middle) - low);
        String end = Double.isFinite(high) ? " to " + Decimals.within(high, uncertainty) : " or more";
        return period.isExact()
                ? Decimals.rounded(middle, DIGITS) + " um"
                : Decimals.within(middle, uncertainty) + " um (" + Decimals.within(low, uncertainty) + end + ")";
    }

    private static String colors(GratingPeriod period, double theta, double phi, List<Band> firstOrders) {
        double turn = rounded(Math.IEEEremainder(phi, 360), 10);
        String light = (theta == 0 ? "light from above" : "light at " + Decimals.rounded(theta, DIGITS) + " degrees")
                + (theta == 0 || turn == 0 ? "" : ", turned by " + Decimals.format(turn) + " degrees");
        if (firstOrders.isEmpty()) {
            return "finer than light, so that " + light + " has no first-order colors";
        }
        if (RED / (period.isSure() ? period.low() : period.period()) < FINEST_ANGLE) {
            return "no visible order can be resolved, all lie within 0.1 degrees of the mirror direction; check the width";
        }
        // Under light from above, the orders +1 and -1 lie at equal angles.
        String angles = firstOrders.stream()
                .limit(theta == 0 ? 1 : 2)
                .map(Verdict::words)
                .collect(Collectors.joining(" and "));
        return "first-order colors " + angles + " under " + light;
    }

    /** sin theta = +-lambda / d - sin theta_i cos phi for all periods in the interval, within the horizon's sine. */
    private static List<Band> firstOrders(GratingPeriod period, double mirror, double horizon) {
        double blue = VIOLET / (period.isSure() ? period.high() : period.period());
        double red = RED / (period.isSure() ? period.low() : period.period());
        return DoubleStream.of(1, -1)
                .filter(side -> Math.abs(mirror + side * blue) < horizon)
                .mapToObj(side -> new Band(
                        degrees(mirror + side * blue),
                        degrees(Math.max(-horizon, Math.min(horizon, mirror + side * red)))))
                .toList();
    }

    private static String words(Band band) {
        int parts = Math.abs(rounded(band.red(), 10) - rounded(band.blue(), 10)) < NARROW ? 10 : 1;
        return Text.format(
                parts > 1 ? "at %.1f to %.1f degrees" : "at %.0f to %.0f degrees",
                rounded(Math.min(band.blue(), band.red()), parts),
                rounded(Math.max(band.blue(), band.red()), parts));
    }

    private static double degrees(double sine) {
        return Math.toDegrees(Math.asin(sine));
    }

    private static double rounded(double degrees, int parts) {
        return Math.rint(parts * degrees) / parts + 0.0;
    }
}
