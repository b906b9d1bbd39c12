package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.apache.commons.math3.distribution.TDistribution;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * Period of a surface's strongest regular wave.
 *
 * @param wave frequency of the wave, directed across its lines; of length 0 if there is no wave
 * @param low lower end of the 95 % interval of the period, meters; the period itself if exact
 * @param azimuthHalfWidth half width of the direction's 95 % interval, radians; 0 if exact, pi/2 if the wave is that of a profile
 * @param periods number in the scan along the wave; infinite for a surface that repeats
 * @param share share of the heights' variance (without waviness) in the wave, or a lattice's waves, and overtones, 0..1
 * @param others up to two waves in other directions and one in the same, each at least half as strong
 * @param reason why the period is not sure; empty if it is
 * @param limit waves that are excluded where no order is found
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
        String reason,
        Optional<WaveLimit> limit) {
    /** In descending order of what is known. */
    public enum Certainty {
        SURE,
        /** Period without a known interval. */
        PROBABLE,
        /** Waves of about the same period run in all directions. */
        ALL_DIRECTIONS,
        TOO_LITTLE,
        NONE
    }

    public static final double PROBABILITY = 0.95;

    // Periods that lines in step with the rows stray by over the scan, of which a hand that mounts a grating of 20
    // periods to a degree leaves 0.35.
    private static final double IN_STEP = 0.25;
    private static final double NANOMETERS_PER_METER = 1e9;
    // Sine of 2 degrees.
    static final double CONE = Hypothesis.CONE;

    public static GratingPeriod of(Patch patch) {
        return PatchPeriod.of(patch, Hypothesis.ANY);
    }

    /**
     * Returns the period of the strongest wave whose period, meters, lies within limits and whose azimuth, across the lines, is the given one if
     * any, radians counter-clockwise from +x. It is tested alone: only waves of these periods and directions compete with it.
     */
    public static GratingPeriod among(Patch patch, OptionalDouble azimuth, double shortest, double longest) {
        return PatchPeriod.of(patch, new Hypothesis(azimuth, shortest, longest));
    }

    static double student(double degreesOfFreedom) {
        return new TDistribution(degreesOfFreedom).inverseCumulativeProbability(0.5 + 0.5 * PROBABILITY);
    }

    /** Returns a wave of any period, on which nothing is decided; {@code waves}: the strongest first, none for a surface without a wave. */
    static GratingPeriod vague(List<SpatialFrequency> waves, double periods, double share) {
        SpatialFrequency wave = waves.isEmpty() ? new SpatialFrequency(0, 0) : waves.get(0);
        List<SpatialFrequency> others = waves.isEmpty() ? waves : waves.subList(1, waves.size());
        double longest = Double.POSITIVE_INFINITY;
        return new GratingPeriod(
                wave, 0, longest, Math.PI, periods, share, others, Certainty.NONE, "", Optional.empty());
    }

    /** Sets the interval of the frequency, cycles per meter, and the half width of the direction's interval, radians. */
    GratingPeriod within(double lowest, double highest, double halfWidth) {
        double longest = lowest > 0 ? 1 / lowest : Double.POSITIVE_INFINITY;
        return new GratingPeriod(
                wave, 1 / highest, longest, halfWidth, periods, share, others, certainty, reason, limit);
    }

    /** Returns the period of some lines that differ in turn, overlaid by the present wave. */
    GratingPeriod longer(int lines) {
        List<SpatialFrequency> waves = Stream.concat(Stream.of(wave.times(1.0 / lines), wave), others.stream())
                .toList();
        return vague(waves, periods / lines, share).within(1 / high / lines, 1 / low / lines, azimuthHalfWidth);
    }

    /** Returns the period along the nearer of x and y, as in a profile: waves of any direction may be cut so. */
    GratingPeriod ofProfile() {
        boolean alongX = Math.abs(wave.x()) >= Math.abs(wave.y());
        SpatialFrequency axis = alongX ? new SpatialFrequency(1, 0) : new SpatialFrequency(0, 1);
        double slant = wave.length() / Math.abs(alongX ? wave.x() : wave.y());
        List<SpatialFrequency> waves =
                waves().stream().map(some -> axis.times(some.length() / slant)).toList();
        return vague(waves, periods, share).within(1 / high / slant, 1 / low / slant, 0.5 * Math.PI);
    }

    GratingPeriod withCertainty(Certainty known, String why) {
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, others, known, why, limit);
    }

    GratingPeriod excluding(Optional<WaveLimit> excluded) {
        String why = reason + excluded.map(waves -> "; " + waves.describe()).orElse("");
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, others, certainty, why, excluded);
    }

    GratingPeriod none(String why) {
        return withCertainty(Certainty.NONE, why);
    }

    GratingPeriod tooLittle(String why) {
        String reason = "too little to judge: " + why + "; use a larger scan, or state that it is periodic";
        return withCertainty(Certainty.TOO_LITTLE, reason);
    }

    /** Returns the period of the surface rotated about its normal, counter-clockwise by an angle in radians. */
    public GratingPeriod turned(double angle) {
        List<SpatialFrequency> turned =
                others.stream().map(other -> other.turned(angle)).toList();
        return new GratingPeriod(
                wave.turned(angle), low, high, azimuthHalfWidth, periods, share, turned, certainty, reason, limit);
    }

    public boolean isSure() {
        return certainty == Certainty.SURE;
    }

    public boolean isSeen() {
        return isSure() || certainty == Certainty.PROBABLE;
    }

    /** Whether order is there, or may be. */
    boolean hasOrder() {
        return certainty != Certainty.NONE;
    }

    /** Whether more is known than by another search, if that found a wave. */
    boolean isBetterThan(Optional<GratingPeriod> other) {
        return other.filter(known -> known.certainty.compareTo(certainty) <= 0).isEmpty();
    }

    public boolean isExact() {
        return low == high;
    }

    public boolean hasWave() {
        return wave.length() > 0;
    }

    public double period() {
        return wave.period();
    }

    /** Returns radians counter-clockwise from +x, above -pi/2 and at most pi/2. */
    public double azimuth() {
        return wave.azimuth();
    }

    public boolean hasDirection() {
        return azimuthHalfWidth < 0.5 * Math.PI;
    }

    /** Returns "along x, its direction is not known". */
    String unknownDirection() {
        String direction = direction(wave);
        String along = Map.of("0 degrees", "x", "90 degrees", "y").getOrDefault(direction, direction);
        return "along " + along + ", its direction is not known";
    }

    /** Whether waves of about one length run in two or three directions. */
    boolean isLattice() {
        return !others.isEmpty()
                && others.stream().allMatch(other -> other.sineTo(wave) > CONE && other.isAsLongAs(wave));
    }

    /** Returns the azimuth rounded to parts of a degree, above -90 and at most 90. */
    private static double degrees(SpatialFrequency wave, int parts) {
        long rounded = Math.round(parts * Math.toDegrees(wave.azimuth()));
        return (double) (rounded == -90L * parts ? -rounded : rounded) / parts;
    }

    static String direction(SpatialFrequency wave) {
        return Text.wholeDegrees(degrees(wave, 1));
    }

    /** Returns "1000.0 nm, 95 % interval 998.9 to 1001.1 nm" with reliable digits. */
    public String interval() {
        double uncertainty = NANOMETERS_PER_METER * (Double.isFinite(high) ? 0.5 * (high - low) : 0.5 * low);
        String middle = Decimals.within(NANOMETERS_PER_METER * period(), uncertainty) + " nm";
        String from = Decimals.within(NANOMETERS_PER_METER * low, uncertainty);
        String to = Double.isFinite(high)
                ? Decimals.within(NANOMETERS_PER_METER * high, uncertainty) + " nm"
                : "any length";
        return isExact() ? middle : middle + ", 95 % interval " + from + " to " + to;
    }

    public String estimate() {
        return isSure() ? interval() : "probably about " + Lengths.rounded(period(), 2) + " (" + reason + ")";
    }

    public List<SpatialFrequency> waves() {
        return Stream.concat(Stream.of(wave), others.stream()).toList();
    }

    /** Returns the azimuths of all waves in whole degrees, above -90 and at most 90, ascending; none if they are not known. */
    public List<Long> directions() {
        return hasDirection()
                ? waves().stream().map(some -> (long) degrees(some, 1)).sorted().toList()
                : List.of();
    }

    /** Returns a note if a scan's lines run along or across its rows, as those of a vibration that is slow, or in step with the rows, do. */
    public Optional<String> caution(Patch patch) {
        if (!isSeen() || isExact() || patch.repetition() == Patch.Repetition.PERIODIC) {
            return Optional.empty();
        }
        HeightMap scan = patch.scan();
        // While a row is scanned, a slow vibration moves on by a row's part of its period.
        boolean along = Math.abs(wave.x()) * scan.width() <= IN_STEP + Math.abs(wave.y()) * scan.pitchY();
        boolean across = Math.abs(wave.y()) * scan.height() <= IN_STEP;
        return along || across
                ? Optional.of("lines exactly " + (along ? "along" : "across")
                        + " the scan's rows may be a vibration's: scan again, turned by 90 degrees; the surface's lines turn,"
                        + " the instrument's do not")
                : Optional.empty();
    }

    public String describe() {
        if (!isSure()) {
            String where = hasDirection() ? ", in direction " + direction(wave) : ", " + unknownDirection();
            return isSeen() ? estimate() + where : "unknown: " + reason;
        }
        String seen = Text.format("; seen %.1f times, %.0f %% of the relevant variance", periods, 100 * share);
        if (!hasDirection()) {
            return interval() + ", " + unknownDirection() + seen;
        }
        // A scanner's axes are known to tenths of a degree.
        String line = interval() + Text.format(", in direction %.1f", degrees(wave, 10));
        if (isExact()) {
            return line + " degrees: the patch repeats";
        }
        return line + Text.format(" +- %.1f degrees", Math.max(0.1, Math.toDegrees(azimuthHalfWidth))) + seen;
    }
}
