package sunbeam.precompute.analysis;

import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.fault.ScanFault;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
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
 * @param crossing a wave across it that is half as strong or stronger; empty where there is none
 * @param refusal why nobody should quote the period, a sentence without a full stop; empty where it is told
 */
public record GratingPeriod(
        SpatialFrequency wave,
        double low,
        double high,
        double azimuthHalfWidth,
        double periods,
        double share,
        Optional<SpatialFrequency> crossing,
        Optional<String> refusal) {
    /** Of the intervals. */
    public static final double PROBABILITY = 0.95;

    private static final double NANOMETRES = 1e9;
    // Of a scan's rows: fewer that repeat the one before weigh less than the half of the scan that a crop may cost.
    private static final double FEW_UNMEASURED = 0.02;
    // Half of sunlight's coherence length: a larger patch shows its period by itself.
    private static final double LARGEST_REPEATED = 32.5e-6;
    // Of a direction that the user gives, to either side: the sine of 2 degrees.
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
        if (!(scan.relief() > 0)) {
            return none("flat: a mirror without color");
        }
        boolean small = Math.max(scan.width(), scan.height()) <= LARGEST_REPEATED;
        Optional<GratingPeriod> exact =
                patch.repetition() == Patch.Repetition.NONE ? Optional.empty() : RepeatedPeriod.of(scan, which);
        if (patch.repetition() == Patch.Repetition.PERIODIC && (small || exact.isPresent())) {
            return exact.orElseGet(() -> none(nothing(where) + " within the patch, which is taken as a period"));
        }
        Optional<GratingPeriod> piece = PeriodModel.of(scan, which);
        boolean told = piece.filter(GratingPeriod::isTold).isPresent();
        return (small && !told && exact.isPresent() ? exact : piece).orElseGet(() -> none(nothing(where)));
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

    private static String nothing(String where) {
        return "no order found: a white gloss without color; nothing repeats" + where;
    }

    private static GratingPeriod none(String why) {
        return vague(new SpatialFrequency(0, 0), 0, 0).refused(why);
    }

    /** Of which nothing is known but the wave. */
    static GratingPeriod vague(SpatialFrequency wave, double periods, double share) {
        return new GratingPeriod(
                wave, 0, Double.POSITIVE_INFINITY, Math.PI, periods, share, Optional.empty(), Optional.empty());
    }

    /** Of a surface that repeats without end. */
    static GratingPeriod exact(SpatialFrequency wave, double share) {
        double period = wave.period();
        return new GratingPeriod(
                wave, period, period, 0, Double.POSITIVE_INFINITY, share, Optional.empty(), Optional.empty());
    }

    /** With an interval of the frequency, cycles per metre, and one of the direction, radians on either side. */
    GratingPeriod within(double lowest, double highest, double turn) {
        double longest = lowest > 0 ? 1 / lowest : Double.POSITIVE_INFINITY;
        return new GratingPeriod(wave, 1 / highest, longest, turn, periods, share, crossing, refusal);
    }

    GratingPeriod crossedBy(Optional<SpatialFrequency> other) {
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, other, refusal);
    }

    GratingPeriod refused(String why) {
        return new GratingPeriod(wave, low, high, azimuthHalfWidth, periods, share, crossing, Optional.of(why));
    }

    /** Of the surface turned about the normal, radians counter-clockwise. */
    public GratingPeriod turned(double angle) {
        return new GratingPeriod(
                wave.turned(angle),
                low,
                high,
                azimuthHalfWidth,
                periods,
                share,
                crossing.map(other -> other.turned(angle)),
                refusal);
    }

    /** Whether the period may be quoted. */
    public boolean isTold() {
        return refusal.isEmpty();
    }

    /** Whether the surface repeats one patch without end, so that its period has no interval. */
    public boolean isExact() {
        return low == high;
    }

    /** Whether any wave was seen, told or not. */
    public boolean hasWave() {
        return wave.length() > 0;
    }

    /** Whether so much of the surface repeats, told or not, that it spreads colors. */
    public boolean hasOrder() {
        return hasWave() && share >= PeriodModel.LEAST_SHARE && periods >= PeriodModel.FEWEST_PERIODS;
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

    /** Degrees, 0 to below 180, as many digits as are known. */
    public String direction() {
        double halfWidth = Math.toDegrees(azimuthHalfWidth);
        String degrees = Decimals.within((Math.toDegrees(azimuth()) + 180) % 180, halfWidth);
        return degrees.startsWith("180") ? Decimals.within(0, halfWidth) : degrees;
    }

    /** The interval, the direction, and what of the heights repeats, in one line. */
    public String describe() {
        double halfWidth = Math.toDegrees(azimuthHalfWidth);
        String line = interval() + ", in direction " + direction();
        return isExact()
                ? line + " degrees: the patch repeats"
                : line
                        + Text.format(
                                " +- %s degrees; seen %.1f times, %.0f %% of the variance that counts",
                                Decimals.rounded(halfWidth, 2), periods, 100 * share);
    }

    /** The exact period of a surface that repeats one patch without end: its strongest frequency, where that is most of it. */
    private static final class RepeatedPeriod {
        // Of the heights' variance, in a wave and its overtones.
        private static final double LEAST_SHARE = 0.4;
        // Of it, in one frequency: more than noise has.
        private static final double OVERTONE = 0.01;

        private RepeatedPeriod() {}

        /** Empty where no frequency of these holds enough. */
        static Optional<GratingPeriod> of(HeightMap map, Predicate<SpatialFrequency> which) {
            HeightSpectrum spectrum = HeightSpectrum.of(map, HeightSpectrum.Edges.PERIODIC);
            double[] power = spectrum.power();
            double all = 0;
            int best = -1;
            int zero = power.length / 2;
            for (int i = zero + 1; i < power.length; i++) {
                all += power[i];
                boolean higher = power[i] > (best < 0 ? 0 : power[best]);
                best = higher && which.test(spectrum.frequency(i)) ? i : best;
            }
            if (best < 0) {
                return Optional.empty();
            }
            int jx = spectrum.bandX().first() + best % spectrum.bandX().count();
            int jy = spectrum.bandY().first() + best / spectrum.bandX().count();
            int number = gcd(jx, jy);
            int fundamental = fundamental(spectrum, jx / number, jy / number, number, OVERTONE * all);
            double explained = overtones(spectrum, jx / number * fundamental, jy / number * fundamental)
                    .sum();
            double part = (double) fundamental / number;
            SpatialFrequency strongest = spectrum.frequency(best);
            SpatialFrequency wave = new SpatialFrequency(part * strongest.x(), part * strongest.y());
            return explained < LEAST_SHARE * all || !which.test(wave)
                    ? Optional.empty()
                    : Optional.of(GratingPeriod.exact(wave, explained / all));
        }

        /** Powers of a bin and of its multiples. */
        private static DoubleStream overtones(HeightSpectrum spectrum, int jx, int jy) {
            return IntStream.iterate(
                            1,
                            k -> spectrum.bandX().holds(k * jx)
                                    && spectrum.bandY().holds(k * jy),
                            k -> k + 1)
                    .mapToDouble(k -> spectrum.at(k * jx, k * jy));
        }

        /** Of what all strong multiples of a bin are multiples; the strongest, whose number is given, may be an overtone. */
        private static int fundamental(HeightSpectrum spectrum, int jx, int jy, int number, double strong) {
            double[] powers = overtones(spectrum, jx, jy).toArray();
            int fundamental = number;
            for (int k = 1; k <= powers.length; k++) {
                fundamental = powers[k - 1] > strong ? gcd(fundamental, k) : fundamental;
            }
            return fundamental;
        }

        private static int gcd(int a, int b) {
            return BigInteger.valueOf(a).gcd(BigInteger.valueOf(b)).intValueExact();
        }
    }
}
