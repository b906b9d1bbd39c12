package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.distribution.TDistribution;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.units.Decimals;

/**
 * The direction in which a wave repeats, and how well a scan tells it. Along the lines of a wave whose direction is known its
 * local amplitudes do not turn; by how much they do, from strip to strip, is the error of the direction that they were looked at
 * along. Amplitudes are compared across a distance as long as the lines go on straight: where they are in step over two thirds
 * of the scan, as those of a drawn grating are, over that, else over less, at last between neighbouring strips. How well that is known comes from what the
 * answer is without each part of the scan in turn (the jackknife), along the wave and across it.
 *
 * @param radians across the lines, counter-clockwise from +x, 0 to below pi
 * @param halfWidth of the interval that holds it with a probability of 95 %, radians
 */
public record WaveDirection(double radians, double halfWidth) {
    private static final double PROBABILITY = PeriodEstimator.PROBABILITY;
    // Periods in the window along the wave and in a strip: as for the period's phase.
    private static final int LONG = 3;
    private static final int SHORT = 2;
    private static final double ENOUGH_FOR_LONG = 9;
    private static final double STRIP = 4;
    private static final int FEWEST_STRIPS = 4;
    private static final int MOST_STRIPS = 24;
    private static final int MOST_PLACES = 24;
    // Of pairs that are in step: a straight grating's.
    private static final double STRAIGHT = 0.9;
    private static final int MOST_GROUPS = 6;
    // Where lines are not straight, neighbouring strips share what they have; measured on simulated gratings.
    private static final double SHARED = 1.9;
    // Of 1 / the lines' length over the frequency: nothing is claimed to better than that.
    private static final double FINEST = 1e-3;
    // Of an interval to either side, degrees: with more a direction and the one across it are as good.
    private static final double MOST_DEGREES = 45;

    /**
     * The direction of a wave whose period is told; of a scan that slipped, in the most rows without a slip.
     *
     * @param map without missing samples
     * @param peak of its spectrum, near the wave
     * @param told of the wave's period
     * @return empty where the scan is too small along the lines, or too narrow across, to tell
     */
    public static Optional<WaveDirection> of(HeightMap map, SpectrumPeak peak, PeriodEstimate told) {
        List<PeriodEstimate.Slip> slips = told.isInPieces() ? told.slips() : List.of();
        int first = 0;
        int longestFirst = 0;
        int longest = 0;
        for (int i = 0; i <= slips.size(); i++) {
            int end = i < slips.size() ? slips.get(i).row() : map.rows();
            if (end - first > longest) {
                longest = end - first;
                longestFirst = first;
            }
            first = end;
        }
        if (longest < 2) {
            return Optional.empty();
        }
        double top = (map.rows() - longestFirst) * map.pitchY();
        HeightMap piece =
                longest == map.rows() ? map : map.part(new Crop(0, map.width(), top - longest * map.pitchY(), top));
        return of(piece, peak, told.period());
    }

    /** @param period of the wave, metres */
    static Optional<WaveDirection> of(HeightMap map, SpectrumPeak peak, double period) {
        double direction = peak.direction();
        Amplitudes amplitudes = Amplitudes.of(map, direction, 1 / period);
        if (amplitudes.strips() < FEWEST_STRIPS) {
            return Optional.empty();
        }
        double slope = 0;
        Pairs best = null;
        for (int lag : new int[] {1, amplitudes.strips() / 3, 2 * amplitudes.strips() / 3}) {
            Pairs pairs = new Pairs(amplitudes, lag);
            if (!pairs.isTold() || (best != null && (pairs.coherence() < STRAIGHT || lag <= best.lag))) {
                break;
            }
            slope = pairs.slope(slope);
            best = pairs;
        }
        if (best == null) {
            return Optional.empty();
        }
        double error = best.error(slope);
        if (!(error < Double.POSITIVE_INFINITY)) {
            return Optional.empty();
        }
        double perRadian = 2 * Math.PI / period;
        double turned = direction + Math.atan(slope / perRadian);
        double positive = turned < 0 ? turned + Math.PI : turned % Math.PI;
        double finest = FINEST * period / (amplitudes.strips() * amplitudes.step);
        double factor = best.lag > 1 ? 1 : SHARED;
        double length = amplitudes.strips() * amplitudes.step;
        double beats = SamplingBeat.errorAcross(map, Math.cos(direction) / period, Math.sin(direction) / period, length)
                * period;
        return Optional.of(new WaveDirection(positive, factor * error / perRadian + finest + beats));
    }

    /**
     * "168.69 +- 0.02 degrees (95 %)", with as many digits as the interval leaves known; "not known" where that is none.
     *
     * @param around degrees, of the half turn that is shown: a direction and its opposite are one
     */
    public String describe(double around) {
        double half = Math.toDegrees(halfWidth);
        if (half > MOST_DEGREES) {
            return "not known";
        }
        double shown = around + Math.IEEEremainder(Math.toDegrees(radians) - around, 180);
        // Within the interval it is as well 0, as people say.
        double near = shown + half >= 180 ? shown - 180 : shown;
        return Decimals.within(near, half) + " +- " + Decimals.within(half, half) + " degrees (95 %)";
    }

    /**
     * Of a wave, in places along it and strips across.
     *
     * @param values {@code [place][strip][re, im]}, null where the window leaves the scan
     * @param step from strip to strip, metres
     */
    private record Amplitudes(double[][][] values, double step) {
        static Amplitudes of(HeightMap map, double direction, double frequency) {
            double cosine = Math.cos(direction);
            double sine = Math.sin(direction);
            DemodulatedHeights heights = DemodulatedHeights.of(map, frequency * cosine, frequency * sine);
            double along = Math.abs(cosine) * heights.width() + Math.abs(sine) * heights.height();
            double across = Math.abs(sine) * heights.width() + Math.abs(cosine) * heights.height();
            int boxes = along * frequency >= ENOUGH_FOR_LONG ? LONG : SHORT;
            double window = boxes / frequency;
            double strip = Math.min(STRIP / frequency, across / FEWEST_STRIPS);
            DemodulatedHeights.Frame frame = new DemodulatedHeights.Frame(cosine, sine, window, strip, boxes);
            int places = count(along, window, MOST_PLACES);
            int strips = count(across, strip, MOST_STRIPS);
            double placeStep = places > 1 ? (along - window) / (places - 1) : 0;
            double stripStep = strips > 1 ? (across - strip) / (strips - 1) : 0;
            double[][][] values = new double[places][strips][];
            for (int place = 0; place < places; place++) {
                for (int i = 0; i < strips; i++) {
                    double s = (place - 0.5 * (places - 1)) * placeStep;
                    double t = (i - 0.5 * (strips - 1)) * stripStep;
                    if (heights.covers(s, t, frame)) {
                        values[place][i] = new double[2];
                        heights.amplitude(s, t, frame, values[place][i]);
                    }
                }
            }
            return new Amplitudes(values, stripStep);
        }

        /** Windows that overlap by half. */
        private static int count(double length, double window, int most) {
            return (int) Math.max(0, Math.min(most, 1 + Math.floor((length - window) / (0.5 * window) * (1 + 1e-9))));
        }

        int places() {
            return values.length;
        }

        int strips() {
            return values.length == 0 ? 0 : values[0].length;
        }
    }

    /** How amplitudes turn over so many strips. */
    private static final class Pairs {
        private final int lag;
        private final double distance;
        private final double[][] ofPlaces;
        private final double[][] ofStrips;
        private final double[] sum = new double[2];
        private double power;
        private int count;

        Pairs(Amplitudes amplitudes, int lag) {
            this.lag = lag;
            this.distance = lag * amplitudes.step;
            int starts = Math.max(0, amplitudes.strips() - lag);
            ofPlaces = new double[Math.min(MOST_GROUPS, (amplitudes.places() + 1) / 2)][2];
            ofStrips = new double[Math.min(MOST_GROUPS, (starts + 1) / 2)][2];
            for (int place = 0; place < amplitudes.places(); place++) {
                for (int i = 0; i < starts; i++) {
                    double[] a = amplitudes.values[place][i];
                    double[] b = amplitudes.values[place][i + lag];
                    if (a != null && b != null) {
                        double real = b[0] * a[0] + b[1] * a[1];
                        double imaginary = b[1] * a[0] - b[0] * a[1];
                        add(sum, real, imaginary);
                        add(ofPlaces[place * ofPlaces.length / amplitudes.places()], real, imaginary);
                        add(ofStrips[i * ofStrips.length / starts], real, imaginary);
                        power += Math.hypot(real, imaginary);
                        count++;
                    }
                }
            }
        }

        private static void add(double[] to, double real, double imaginary) {
            to[0] += real;
            to[1] += imaginary;
        }

        boolean isTold() {
            return count > 1 && power > 0;
        }

        /** 0..1: how much of the pairs turns alike. */
        double coherence() {
            return Math.hypot(sum[0], sum[1]) / power;
        }

        /** Radians per metre, of those that look the same the nearest to a guess. */
        double slope(double guess) {
            return slope(sum, guess);
        }

        private double slope(double[] of, double guess) {
            double turn = Math.atan2(of[1], of[0]);
            return guess + Math.IEEEremainder(turn - guess * distance, 2 * Math.PI) / distance;
        }

        /** Half width of the slope's interval; infinite where nothing can be left out. */
        double error(double slope) {
            double variance = 0;
            double uncertain = 0;
            for (double[][] groups : new double[][][] {ofPlaces, ofStrips}) {
                int filled = 0;
                double squares = 0;
                for (double[] group : groups) {
                    double[] rest = {sum[0] - group[0], sum[1] - group[1]};
                    if (group[0] != 0 && Math.hypot(rest[0], rest[1]) > 0) {
                        filled++;
                        double change = slope(rest, slope) - slope;
                        squares += change * change;
                    }
                }
                if (filled > 1) {
                    double part = squares * (filled - 1) / filled;
                    variance += part;
                    uncertain += part * part / (filled - 1);
                }
            }
            if (!(uncertain > 0)) {
                return Double.POSITIVE_INFINITY;
            }
            // Welch and Satterthwaite's, of a sum of variances.
            double freedom = variance * variance / uncertain;
            return new TDistribution(freedom).inverseCumulativeProbability(0.5 + 0.5 * PROBABILITY)
                    * Math.sqrt(variance);
        }
    }
}
