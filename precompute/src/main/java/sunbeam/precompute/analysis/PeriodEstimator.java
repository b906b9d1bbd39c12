package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;

/**
 * How well a scan tells a period. The wave is followed through the scan place by place; noise, strayed lines, uneven
 * gaps and the scan's few periods all leave their trace in its phase, and {@link PhaseFit} makes an interval of that.
 */
public final class PeriodEstimator {
    /** Of the intervals. */
    public static final double PROBABILITY = 0.95;

    // Of a curvature that chance may leave in the phase of a grating that does not drift.
    private static final double CERTAINTY = 0.99;
    // A scan's resolution is 1 / its length; no frequency is claimed to better than this share of it.
    private static final double FINEST = 1e-3;
    private static final double FINEST_OF_TWO = 0.02;
    // Windows that do not overlap: in fewer, two waves explain much of what an uneven grating does, but not all.
    private static final double FEWEST_FOR_TWO = 4;
    private static final double NEAT = 1e-3;
    // Lines that bend are closer to each other than along their mean direction; windows and strips even that out
    // somewhat.
    private static final double BENT = 1.5;
    // Strips of a grown surface count by their amplitudes, not alike, and fewer of them than there are are independent;
    // measured on simulated ones.
    private static final double UNEQUAL_STRIPS = 1.5;
    // A phase that wanders for long shows only some of its ways in a scan: measured on simulated ones.
    private static final double FEW_WANDERINGS = 0.6;
    // Amplitudes of one wave under windows of three periods differ by so much, by noise and disorder.
    private static final double EVEN = 0.2;
    private static final double BEAT = 0.8;
    // Two waves in step in the middle of the scan fade to both sides as cos(phi), and (1 - cos phi) / (1 + cos phi) is
    // phi^2 / 4: with phi pi
    // times half of their distance, over the 0.85 of the scan where windows fit. Scanners fade less.
    private static final double LEAST_FADING = 0.05;
    private static final double BEATS_TO_TELL = 1.5;
    private static final double BEAT_IN_STEP = 2 / (0.85 * Math.PI);
    private static final int ROUNDS = 3;
    // Of a line across the scan, by which another round would move: what is left is found by the fit.
    private static final double SETTLED = 1e-3;
    // Half an interval over the period.
    private static final double LEAST_OF_GROWN = 0.02;
    // Halves of a scan tell little more, and take as long again.
    private static final double WIDE = 0.1;

    private PeriodEstimator() {}

    /**
     * The period near a peak of the heights' spectrum, along the peak's direction; empty where too few periods fit into
     * the scan to tell, or between rows at which it slipped.
     *
     * @param map without missing samples
     */
    public static Optional<PeriodEstimate> estimate(HeightMap map, SpectrumPeak peak) {
        return estimate(new ScanHalves(map), peak);
    }

    /** As {@link #estimate(HeightMap, SpectrumPeak)}, for several peaks of a scan. */
    public static Optional<PeriodEstimate> estimate(ScanHalves scan, SpectrumPeak peak) {
        return followed(scan, peak).map(told -> told.doubted(doubt(scan, peak, told)));
    }

    private static PeriodEstimate.Doubt doubt(ScanHalves scan, SpectrumPeak peak, PeriodEstimate told) {
        HeightMap map = scan.whole();
        if (HalfShiftedRows.in(map, peak, told)) {
            return PeriodEstimate.Doubt.HALF_SHIFTED;
        }
        if (scan.fineWaves().mayHaveLeft(peak)) {
            return PeriodEstimate.Doubt.ALIAS;
        }
        if (LevelledRows.spoil(map, peak)) {
            return PeriodEstimate.Doubt.LEVELLED_ROWS;
        }
        return ChanceLines.in(map, peak, told) ? PeriodEstimate.Doubt.CHANCE : PeriodEstimate.Doubt.NONE;
    }

    private static Optional<PeriodEstimate> followed(ScanHalves scan, SpectrumPeak peak) {
        HeightMap map = scan.whole();
        RowSlips rows = RowSlips.in(map, peak.frequencyX(), peak.frequencyY());
        List<PeriodEstimate.Slip> slips = rows.slips();
        ScanPieces pieces = new ScanPieces(scan, peak);
        if (slips.isEmpty()) {
            return ofOnePiece(map, peak)
                    .map(told -> told.second().isPresent() ? told : pieces.comparedWithHalves(told));
        }
        if (slips.size() <= PeriodEstimate.MOST_SLIPS_FOLLOWED) {
            List<PeriodEstimate> told = pieces.between(slips);
            return told.stream()
                    .findFirst()
                    .map(largest -> largest.reaching(told).slippedAt(slips));
        }
        return ofMany(map, peak, rows)
                .map(told -> told.halfWidth() > WIDE * told.period() ? told : pieces.reachingHalves(told));
    }

    /**
     * A scanner that slips often, which moving its rows back mends; or a grown surface whose lines end, of which moved rows tell
     * less.
     */
    private static Optional<PeriodEstimate> ofMany(HeightMap map, SpectrumPeak peak, RowSlips rows) {
        Optional<PeriodEstimate> asItIs = ofOnePiece(map, peak);
        Optional<PeriodEstimate> moved = new MendedRows(map, peak, rows).estimate();
        if (asItIs.isEmpty() || moved.isEmpty()) {
            return Optional.empty();
        }
        PeriodEstimate whole = asItIs.get();
        PeriodEstimate mended = moved.get();
        boolean grown = whole.halfWidth() > LEAST_OF_GROWN * whole.period();
        if (grown && mended.halfWidth() > whole.halfWidth()) {
            return Optional.of(whole.slippedAt(rows.slips()));
        }
        PeriodEstimate first = grown ? whole : mended;
        return Optional.of(first.within(Math.min(whole.low(), mended.low()), Math.max(whole.high(), mended.high()))
                .slippedAt(rows.slips()));
    }

    /** As if all rows continued each other. */
    static Optional<PeriodEstimate> ofOnePiece(HeightMap map, SpectrumPeak peak) {
        double direction = Math.atan2(peak.frequencyY(), peak.frequencyX());
        double frequency = peak.frequency();
        PhaseSeries series = null;
        for (int round = 0; round < ROUNDS; round++) {
            series = PhaseSeries.of(map, frequency * Math.cos(direction), frequency * Math.sin(direction));
            if (series.size() < PhaseFit.FEWEST) {
                return Optional.empty();
            }
            if (round + 1 < ROUNDS) {
                double better = moved(frequency, series.roughSlope(), series);
                // Phases of half a turn a place would be another wave's.
                boolean other = !(better > 0.7 * peak.frequency() && better < 1.4 * peak.frequency());
                if (other || Math.abs(better - frequency) * series.size() * series.step() < SETTLED) {
                    break;
                }
                frequency = better;
            }
        }
        double length = (series.size() + 1) * series.step();
        double beats =
                SamplingBeat.error(map, frequency * Math.cos(direction), frequency * Math.sin(direction), length);
        PeriodEstimate told = told(frequency, series, beats);
        return Optional.of(
                told.second()
                                .filter(second -> isMirrored(map, direction, 1 / second.period()))
                                .isPresent()
                        ? told.alone()
                        : told);
    }

    /** Few samples a period show each wave a second time, mirrored at half the sampling frequency. */
    private static boolean isMirrored(HeightMap map, double direction, double frequency) {
        return Math.abs(frequency * Math.cos(direction)) * map.pitchX() > 0.5
                || Math.abs(frequency * Math.sin(direction)) * map.pitchY() > 0.5;
    }

    private static double moved(double frequency, double slope, PhaseSeries series) {
        return frequency + slope / (2 * Math.PI * series.step());
    }

    private static PeriodEstimate told(double frequency, PhaseSeries series, double beats) {
        PhaseFit fit = new PhaseFit(series);
        double length = (series.size() + 1) * series.step();
        double finest = FINEST / length;
        Optional<TwoWaves> two = series.isStraight() ? TwoWaves.in(series.straight()) : Optional.empty();
        boolean trusted = ((series.size() - 1) / series.window() >= FEWEST_FOR_TWO
                        || two.filter(waves -> waves.rest() <= NEAT).isPresent())
                && !two.filter(waves -> isPartOfABeat(waves, series)).isPresent();
        if (two.isPresent() && trusted) {
            return ofTwo(frequency, series, two.get(), length);
        }
        PhaseFit.Interval slope = fit.slope(PROBABILITY);
        double middle = moved(frequency, slope.median(), series);
        double wider = (series.isStraight() ? 1 : UNEQUAL_STRIPS) * (1 + FEW_WANDERINGS * fit.wandering());
        finest = Math.max(finest, beat(series) / length) + beats;
        double low = Math.min(middle + wider * (moved(frequency, slope.low(), series) - middle), middle - finest);
        double high = Math.max(middle + wider * (moved(frequency, slope.high(), series) - middle), middle + finest)
                + BENT * series.bend() * middle;
        if (two.isPresent()) {
            // They may be two, or one whose lines are broken: the interval holds whatever is the truth.
            double first = moved(frequency, two.get().first(), series);
            double second = moved(frequency, two.get().second(), series);
            low = Math.min(low, Math.min(first, second) - FINEST_OF_TWO / length);
            high = Math.max(high, Math.max(first, second) + FINEST_OF_TWO / length);
        }
        Optional<PeriodEstimate.Drift> drift = drift(frequency, fit, series);
        if (drift.isPresent()) {
            // Which of its periods is meant is not known.
            low = Math.min(low, 1 / Math.max(drift.get().first(), drift.get().last()));
            high = Math.max(high, 1 / Math.min(drift.get().first(), drift.get().last()));
        }
        return new PeriodEstimate(
                1 / middle,
                1 / high,
                low > 0 ? 1 / low : Double.POSITIVE_INFINITY,
                length * middle,
                Optional.empty(),
                drift);
    }

    /**
     * How far from the found frequency one of two waves may lie that the scan is too short to tell apart, in units of its
     * resolution: their beat shows as a growing or falling amplitude. 0 where that is even, or lines are not straight.
     */
    private static double beat(PhaseSeries series) {
        double largest = Arrays.stream(series.strengths()).max().orElseThrow();
        double least = Arrays.stream(series.strengths()).min().orElseThrow();
        double change = (largest - least) / (largest + least);
        if (!series.isStraight()) {
            return 0;
        }
        double fading = FadingStrength.sag(series.strengths());
        return Math.max(
                change > EVEN ? BEAT * change : 0, fading > LEAST_FADING ? BEAT_IN_STEP * Math.sqrt(fading) : 0);
    }

    /** Two waves of which one that fades to both sides is as good an explanation as another two. */
    private static boolean isPartOfABeat(TwoWaves two, PhaseSeries series) {
        double turns = Math.abs(two.first() - two.second()) / (2 * Math.PI) * (series.size() + 1);
        return turns < BEATS_TO_TELL && FadingStrength.sag(series.strengths()) > LEAST_FADING;
    }

    private static Optional<PeriodEstimate.Drift> drift(double frequency, PhaseFit fit, PhaseSeries series) {
        PhaseFit.Interval curvature = fit.curvature(CERTAINTY);
        if (series.size() <= PhaseFit.FEWEST || (curvature.low() <= 0 && curvature.high() >= 0)) {
            return Optional.empty();
        }
        double middle = fit.slopeInTheMiddle(PROBABILITY).median();
        double change = curvature.median() * series.size();
        double first = moved(frequency, middle - change, series);
        double last = moved(frequency, middle + change, series);
        return first > 0 && last > 0 ? Optional.of(new PeriodEstimate.Drift(1 / first, 1 / last)) : Optional.empty();
    }

    /** Two waves' frequencies; each is known as well as the rest of the other allows (Rife and Boorstyn's bound). */
    private static PeriodEstimate ofTwo(double frequency, PhaseSeries series, TwoWaves two, double length) {
        double first = moved(frequency, two.first(), series);
        double second = moved(frequency, two.second(), series);
        // Variance of a frequency: 6 / (4 pi^2) noise over signal / (places length^2); the rest is never less than what
        // the windows leave of each other's waves.
        double noise = Math.max(two.rest(), 1e-6) * (1 + two.ratio() * two.ratio());
        // Neighbouring places' windows overlap, so that only every so many-th counts.
        double independent = series.size() / series.window();
        double error = Math.sqrt(6 * noise / independent) / (2 * Math.PI * length);
        double wide = Math.max(2.5 * error, FINEST_OF_TWO / length);
        double wider = wide / two.ratio();
        return new PeriodEstimate(
                1 / first,
                1 / (first + wide),
                1 / (first - wide),
                length * first,
                Optional.of(
                        new PeriodEstimate.Second(1 / second, 1 / (second + wider), 1 / (second - wider), two.ratio())),
                Optional.empty());
    }
}
