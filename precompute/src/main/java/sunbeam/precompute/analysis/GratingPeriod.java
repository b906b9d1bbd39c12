package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.stream.Stream;
import sunbeam.precompute.fault.ScanFault;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * Period of a surface: that of its strongest regular wave, and how sure it is.
 *
 * @param wave direction across the lines, and the frequency; of length 0 where there is none
 * @param low lower end of the interval that holds the period with a probability of 95 %, metres; the period where it is exact
 * @param high upper end, metres
 * @param azimuthHalfWidth half width of the 95 % interval of the direction, radians; 0 where it is exact
 * @param periods number of periods in the scan along the wave; infinite for a surface that repeats without end
 * @param share 0..1: what the wave and its overtones hold of the heights' variance, less what is coarser than two periods
 * @param others up to two waves in other directions that are half as strong or stronger
 * @param certainty whether there is such a wave
 * @param reason why the period is not sure, without a full stop; empty where it is
 */
public record GratingPeriod(
        SpatialFrequency wave,
        double low,
        double high,
        double azimuthHalfWidth,
        double periods,
        double share,
        List<SpatialFrequency> others,
        Certainty certainty,
        String reason) {
    /** How well a period is known. */
    public enum Certainty {
        /** With its interval. */
        SURE,
        /** Seen, but without an interval. */
        PROBABLE,
        /** Waves of about one length in all directions. */
        ALL_DIRECTIONS,
        /** No wave stands out. */
        NONE,
        /** The scan is too small to show one. */
        TOO_LITTLE
    }

    /** Probability that an interval holds the true period. */
    public static final double PROBABILITY = 0.95;

    private static final double NANOMETRES = 1e9;
    // Share of rows without measurement from which the scan is cropped; a crop may cost half of it.
    private static final double FEW_UNMEASURED = 0.02;
    // Half of sunlight's coherence length: a larger patch shows its period by itself.
    private static final double LARGEST_REPEATED = 32.5e-6;
    // Sine of 2 degrees: waves this near to a direction that the user gives count.
    private static final double CONE = 0.035;
    // Three periods of four samples.
    private static final int FEWEST_SAMPLES = 12;
    // Three periods of which light from above shows an order, metres.
    private static final double SHORTEST_SIDE = 3 * Verdict.VIOLET;
    private static final double ALIKE = 0.05;
    private static final double MANY_LINES = 2.5;

    /** Period of a patch's strongest wave, in any direction. */
    public static GratingPeriod of(Patch patch) {
        return of(patch, wave -> true, "");
    }

    /**
     * Period of a patch's strongest wave within limits.
     *
     * @param azimuth direction across the lines, radians counter-clockwise from +x; empty for any
     * @param shortest period, metres
     * @param longest period, metres
     */
    public static GratingPeriod among(Patch patch, OptionalDouble azimuth, double shortest, double longest) {
        Predicate<SpatialFrequency> which = wave -> wave.period() >= shortest && wave.period() <= longest;
        if (azimuth.isEmpty()) {
            return of(patch, which, "");
        }
        double angle = azimuth.getAsDouble();
        SpatialFrequency direction = new SpatialFrequency(Math.cos(angle), Math.sin(angle));
        String where = " along azimuth " + Decimals.format(Math.rint(100 * Math.toDegrees(angle)) / 100) + " degrees";
        return of(patch, which.and(wave -> wave.length() > 0 && wave.sineTo(direction) < CONE), where);
    }

    private static GratingPeriod of(Patch patch, Predicate<SpatialFrequency> which, String where) {
        HeightMap scan = measured(patch.scan(), patch.faults());
        GratingPeriod nothing = vague(new SpatialFrequency(0, 0), 0, 0);
        if (!(scan.relief() > 0)) {
            return nothing.not("flat: a mirror without color");
        }
        String none = "no order found: a white gloss without color; nothing repeats" + where;
        double side = Math.max(scan.width(), scan.height());
        boolean small = side <= LARGEST_REPEATED;
        boolean periodic = patch.repetition() == Patch.Repetition.PERIODIC;
        Optional<GratingPeriod> exact = patch.repetition() == Patch.Repetition.NONE
                ? Optional.empty()
                : RepeatedPeriod.of(scan, which, periodic);
        // Many lines that differ within a period are a grating whose orders are split.
        boolean lines = exact.filter(found -> found.period() > MANY_LINES * Verdict.VIOLET)
                .isPresent();
        if (periodic && !lines && (small || exact.isPresent())) {
            return exact.orElseGet(() -> nothing.not(none + " within the patch, which is taken as a period"));
        }
        if (!(periodic && exact.isPresent()) && Math.max(scan.columns(), scan.rows()) < FEWEST_SAMPLES) {
            return nothing.tooLittle(Text.format(
                    "%d x %d samples, and three periods take %d", scan.columns(), scan.rows(), FEWEST_SAMPLES));
        }
        GratingPeriod piece = PeriodModel.of(scan, which).orElseGet(() -> nothing.not(none));
        if (periodic && exact.isPresent()) {
            return piece.isSeen() && exact.get().period() > MANY_LINES * piece.period() ? piece : exact.get();
        }
        if (!piece.isSeen() && side < SHORTEST_SIDE) {
            return nothing.tooLittle(Text.format(
                    "a side of %s, and three periods whose colors are seen from above take %s",
                    Lengths.rounded(side, 3), Lengths.format(SHORTEST_SIDE)));
        }
        boolean isPiece =
                piece.isSure() || (piece.isSeen() && exact.filter(piece::agrees).isEmpty());
        return small && !isPiece ? exact.orElse(piece) : piece;
    }

    private boolean agrees(GratingPeriod other) {
        return Math.abs(other.period() / period() - 1) < ALIKE;
    }

    /** The largest part of a scan without the rows that hold no measurement: what repeats in them is not the surface. */
    static HeightMap measured(HeightMap scan, List<ScanFault> faults) {
        return faults.stream()
                .filter(fault -> fault.unmeasured() > FEW_UNMEASURED)
                .flatMap(fault -> fault.part().stream())
                .findFirst()
                .map(part -> part.apply(scan))
                .orElse(scan);
    }

    /** A wave without interval. */
    static GratingPeriod vague(SpatialFrequency wave, double periods, double share) {
        return new GratingPeriod(
                wave, 0, Double.POSITIVE_INFINITY, Math.PI, periods, share, List.of(), Certainty.SURE, "");
    }

    /** Exact period of a surface that repeats without end. */
    static GratingPeriod exact(SpatialFrequency wave, double share) {
        double period = wave.period();
        return new GratingPeriod(
                wave, period, period, 0, Double.POSITIVE_INFINITY, share, List.of(), Certainty.SURE, "");
    }

    /** With an interval of the frequency, cycles per metre, and one of the direction, radians on either side. */
    GratingPeriod within(double lowest, double highest, double turn) {
        double longest = lowest > 0 ? 1 / lowest : Double.POSITIVE_INFINITY;
        return new GratingPeriod(wave, 1 / highest, longest, turn, periods, share, others, certainty, reason);
    }

    GratingPeriod with(List<SpatialFrequency> crossing) {
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, crossing, certainty, reason);
    }

    GratingPeriod as(Certainty known, String why) {
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, others, known, why);
    }

    GratingPeriod not(String why) {
        return as(Certainty.NONE, why);
    }

    GratingPeriod probably(String why) {
        return as(Certainty.PROBABLE, why);
    }

    private GratingPeriod tooLittle(String why) {
        return as(
                Certainty.TOO_LITTLE,
                "too little to judge: " + why + "; take a larger scan, or say that it is periodic");
    }

    /** Period of the surface turned about its normal, radians counter-clockwise. */
    public GratingPeriod turned(double angle) {
        List<SpatialFrequency> turned =
                others.stream().map(other -> other.turned(angle)).toList();
        return new GratingPeriod(
                wave.turned(angle), low, high, azimuthHalfWidth, periods, share, turned, certainty, reason);
    }

    /** Whether the period may be quoted, with its interval. */
    public boolean isSure() {
        return certainty == Certainty.SURE;
    }

    /** Whether there is a period, sure or probable. */
    public boolean isSeen() {
        return isSure() || certainty == Certainty.PROBABLE;
    }

    /** Whether the surface repeats one patch without end, so that its period has no interval. */
    public boolean isExact() {
        return low == high;
    }

    /** Whether there is any wave, seen or not. */
    public boolean hasWave() {
        return wave.length() > 0;
    }

    /** Metres. */
    public double period() {
        return wave.period();
    }

    /** Radians counter-clockwise from +x, above -pi/2 to pi/2. */
    public double azimuth() {
        return wave.azimuth();
    }

    /** Degrees, 0 to below 180, for people. */
    static long degrees(SpatialFrequency wave) {
        return Math.floorMod(Math.round(Math.toDegrees(wave.azimuth())), 180L);
    }

    /**
     * "1000.0 nm, 95 % interval 998.9 to 1001.1 nm", as many digits as the interval leaves known, or the period alone where
     * it is exact.
     */
    public String interval() {
        double uncertainty = NANOMETRES * (Double.isFinite(high) ? 0.5 * (high - low) : 0.5 * low);
        String middle = Decimals.within(NANOMETRES * period(), uncertainty) + " nm";
        return isExact()
                ? middle
                : middle + ", 95 % interval " + Decimals.within(NANOMETRES * low, uncertainty) + " to "
                        + (Double.isFinite(high)
                                ? Decimals.within(NANOMETRES * high, uncertainty) + " nm"
                                : "any length");
    }

    /** The interval, or where it is not sure "probably about 2.9 um (3.4 periods seen, too few for an interval)". */
    public String told() {
        return isSure() ? interval() : "probably about " + Lengths.rounded(period(), 2) + " (" + reason + ")";
    }

    /** Directions of the wave and of the others, degrees, 0 to below 180, ascending. */
    public List<Long> directions() {
        return Stream.concat(Stream.of(wave), others.stream())
                .map(GratingPeriod::degrees)
                .sorted()
                .toList();
    }

    /** The interval, the direction, and what of the heights repeats, in one line; where it is not sure, why. */
    public String describe() {
        if (!isSure()) {
            return isSeen() ? told() + ", in direction " + degrees(wave) + " degrees" : "not told: " + reason;
        }
        // No direction is known better than a scanner's axes are at right angles: tenths of a degree.
        double tenths = Math.floorMod(Math.round(10 * Math.toDegrees(azimuth())), 1800L) / 10.0;
        String line = interval() + Text.format(", in direction %.1f", tenths);
        return isExact()
                ? line + " degrees: the patch repeats"
                : line
                        + Text.format(
                                " +- %.1f degrees; seen %.1f times, %.0f %% of the variance that counts",
                                Math.max(0.1, Math.toDegrees(azimuthHalfWidth)), periods, 100 * share);
    }
}
