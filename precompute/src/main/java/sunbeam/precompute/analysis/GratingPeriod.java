package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchFault;
import sunbeam.precompute.units.Decimals;

/**
 * What a surface tells of its period: that of its strongest regular wave.
 *
 * @param wave direction across the lines, and the frequency
 * @param low lower end of the interval that holds the period with a probability of 95 %, metres; the period where it is exact
 * @param high upper end, metres
 * @param azimuthHalfWidth half width of the 95 % interval of the direction, radians; 0 where it is exact
 * @param periods how many of them fit into the scan along the wave; infinite for a surface that repeats without end
 * @param share 0..1: what the wave and its overtones hold of the heights' variance, less what is coarser than two periods
 * @param refusal why nobody should quote the period, a sentence without a full stop; empty where it is told
 */
public record GratingPeriod(
        SpatialFrequency wave,
        double low,
        double high,
        double azimuthHalfWidth,
        double periods,
        double share,
        Optional<String> refusal) {
    /** Of the intervals. */
    public static final double PROBABILITY = 0.95;

    private static final double MOST_UNMEASURED = 0.02;
    // Half of sunlight's coherence length: a larger patch shows its period by itself.
    private static final double LARGEST_REPEATED = 32.5e-6;
    // The sine of 2 degrees.
    private static final double CONE = 0.035;

    /** Of a patch's strongest wave in any direction. */
    public static GratingPeriod of(Patch patch) {
        return of(patch, wave -> true, "");
    }

    /**
     * Of the strongest of some waves of a patch.
     *
     * @param azimuth direction near which they are looked for, radians counter-clockwise from +x; empty for all
     * @param shortest period, metres
     * @param longest period, metres
     */
    public static GratingPeriod among(Patch patch, OptionalDouble azimuth, double shortest, double longest) {
        Predicate<SpatialFrequency> which = azimuth.isPresent() ? near(azimuth.getAsDouble()) : wave -> true;
        String where = azimuth.isPresent()
                ? " along azimuth " + Decimals.format(Math.rint(100 * Math.toDegrees(azimuth.getAsDouble())) / 100)
                        + " degrees"
                : "";
        return of(patch, which.and(wave -> wave.period() >= shortest && wave.period() <= longest), where);
    }

    private static Predicate<SpatialFrequency> near(double azimuth) {
        SpatialFrequency direction = new SpatialFrequency(Math.cos(azimuth), Math.sin(azimuth));
        return wave -> wave.length() > 0 && wave.sineTo(direction) < CONE;
    }

    private static GratingPeriod of(Patch patch, Predicate<SpatialFrequency> which, String where) {
        if (!(patch.scan().relief() > 0)) {
            return none("flat: a mirror without color");
        }
        boolean small = Math.max(patch.scan().width(), patch.scan().height()) <= LARGEST_REPEATED;
        Optional<GratingPeriod> exact = RepeatedPeriod.of(patch.scan(), which);
        Optional<GratingPeriod> period = switch (patch.repetition()) {
            case PERIODIC -> small || exact.isPresent() ? exact : PeriodModel.of(patch.scan(), which);
            case NONE -> PeriodModel.of(patch.scan(), which);
            case ASSUMED -> {
                Optional<GratingPeriod> piece = PeriodModel.of(patch.scan(), which);
                boolean told = piece.filter(GratingPeriod::isTold).isPresent();
                yield small && !told && exact.isPresent() ? exact : piece;
            }
        };
        return period.orElseGet(() -> none("no order found: a white gloss without color; nothing repeats" + where))
                .unlessUnmeasured(patch.faults());
    }

    private static GratingPeriod none(String why) {
        return new GratingPeriod(
                new SpatialFrequency(0, 0), 0, Double.POSITIVE_INFINITY, Math.PI, 0, 0, Optional.of(why));
    }

    /** Whether the period may be quoted. */
    public boolean isTold() {
        return refusal.isEmpty();
    }

    /** Whether the surface repeats one patch without end, so that its period has no interval. */
    public boolean isExact() {
        return low == high;
    }

    /** Metres. */
    public double period() {
        return wave.period();
    }

    /** Radians counter-clockwise from +x, above -pi/2 to pi/2. */
    public double azimuth() {
        return wave.azimuth();
    }

    /** Refused where more than a fiftieth of the scan's rows were not measured: what repeats in them is not the surface. */
    GratingPeriod unlessUnmeasured(List<PatchFault> faults) {
        double share = faults.stream().mapToDouble(PatchFault::unmeasured).sum();
        return faults.stream()
                .filter(fault -> share > MOST_UNMEASURED && fault.unmeasured() > 0)
                .findFirst()
                .map(fault -> refused("no period is told of a scan of which " + fault.line()))
                .orElse(this);
    }

    /** With an interval of the frequency, cycles per metre, and one of the direction, radians on either side. */
    GratingPeriod within(double lowest, double highest, double turn) {
        double longest = lowest > 0 ? 1 / lowest : Double.POSITIVE_INFINITY;
        return new GratingPeriod(wave, 1 / highest, longest, turn, periods, share, refusal);
    }

    /** "1000.0 nm, 95 % interval 998.9 to 1001.1 nm", or the period alone where it is exact. */
    public String describe() {
        return isExact() ? IntervalWords.period(period(), low, high) : IntervalWords.of(period(), low, high);
    }

    /** Whether any wave was seen, told or not. */
    public boolean hasWave() {
        return wave.length() > 0;
    }

    /** Whether so much of the surface repeats, told or not, that it spreads colors. */
    public boolean hasOrder() {
        return hasWave() && share >= PeriodModel.LEAST_SHARE && periods >= PeriodModel.FEWEST_PERIODS;
    }

    GratingPeriod refused(String why) {
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, Optional.of(why));
    }
}
