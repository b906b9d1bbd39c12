package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import sunbeam.precompute.numerics.LogParabola;

/**
 * Peaks in the spectrum of a piece of a surface, found in bins averaged with their neighbours. Natural surfaces keep no
 * exact period: one scan of them shows a broad peak as a cluster of speckles, which only the average makes one.
 */
final class TaperedPeaks {
    /**
     * What a peak's figure must reach where the patch has rows and columns. Averaged noise stays below 2 all over, below
     * 3.2 along a line (see the tests).
     */
    static final double THRESHOLD = 5;

    /** The same for a single row or column, where fewer bins are averaged and noise stays below 4. */
    static final double THRESHOLD_ON_ONE_AXIS = 7;

    // Average over 4 pi sigma^2 = 200 bins, of which the Hann window leaves 90 independent: noise of 11 %.
    private static final double COARSE_BINS = 4;
    // Below this bin the coarse average would draw in the waviness around bin 0.
    private static final double COARSE_FROM_BIN = 3 * COARSE_BINS;
    private static final double FINE_BINS = 2;
    // Fewer repetitions across the patch cannot be told from its waviness.
    private static final double FEWEST_PERIODS = 4;
    // A Hann window spreads one frequency over two bins on each side.
    private static final int LINE_BINS = 2;
    // Of the power within the resolution, what lies in one such line when that is an exact grating's.
    private static final double SHARP_SHARE = 0.8;
    // Weaker ones, by their heights, are not worth a line beside the strongest.
    private static final double WEAKEST = 0.1;

    // Of the variance, below which a wave may be a staircase of samples; and always is, of so few samples a period.
    private static final double STAIRCASE_SHARE = 0.01;
    private static final double STAIRCASE_SAMPLES = 3;
    // Of the average's deviation: so far away a line of the spectrum has gone, and a crest still has this share of its
    // height.
    private static final int[] CREST_DEVIATIONS = {3, 4};
    private static final double CREST_SHARE = 0.25;
    private static final int CREST_DIRECTIONS = 24;

    private final HeightSpectrum spectrum;
    private final double pitchX;
    private final double pitchY;
    private final double variance;
    private final Scale fine;
    private final Scale coarse;
    private final double threshold;

    /** A spectrum averaged over some bins, and the range of bins in which its maxima count. */
    private record Scale(
            HeightSpectrum smoothed, LocalBackground background, double sigmaBins, double fromBin, double toBin) {
        static Scale of(HeightSpectrum spectrum, double sigmaBins, double fromBin, double toBin) {
            HeightSpectrum smoothed = spectrum.smoothed(sigmaBins);
            return new Scale(smoothed, new LocalBackground(smoothed), sigmaBins, fromBin, toBin);
        }

        boolean counts(double binX, double binY) {
            double bin = Math.hypot(binX, binY);
            return bin >= fromBin && bin < toBin;
        }
    }

    /**
     * @param pitchX distance of the heights' samples along x, metres; the spectrum may end before they do
     * @param pitchY and along y
     */
    TaperedPeaks(HeightSpectrum spectrum, double pitchX, double pitchY) {
        this.spectrum = spectrum;
        this.pitchX = pitchX;
        this.pitchY = pitchY;
        this.variance = Arrays.stream(spectrum.power()).sum() - spectrum.at(0, 0);
        boolean oneAxis = spectrum.bandX().count() == 1 || spectrum.bandY().count() == 1;
        this.threshold = oneAxis ? THRESHOLD_ON_ONE_AXIS : THRESHOLD;
        this.fine = Scale.of(spectrum, FINE_BINS, FEWEST_PERIODS, COARSE_FROM_BIN);
        this.coarse = Scale.of(spectrum, COARSE_BINS, COARSE_FROM_BIN, Double.POSITIVE_INFINITY);
    }

    /** All regularities, the strongest first, without those that are overtones of stronger ones. */
    Periodicity all() {
        List<SpectrumPeak> candidates = new ArrayList<>();
        for (Scale scale : List.of(coarse, fine)) {
            HeightSpectrum smoothed = scale.smoothed();
            for (int jy = 0; jy <= smoothed.bandY().last(); jy++) {
                int first = jy == 0 ? 1 : smoothed.bandX().first();
                for (int jx = first; jx <= smoothed.bandX().last(); jx++) {
                    if (scale.counts(jx, jy) && isMaximum(smoothed, jx, jy)) {
                        candidates.add(refined(scale, jx, jy));
                    }
                }
            }
        }
        return chosen(candidates);
    }

    /**
     * Regularities along one direction.
     *
     * @param azimuth radians
     * @param tolerance standard deviation, cycles per metre, of how far from the line in this direction light looks
     */
    Periodicity along(double azimuth, double tolerance) {
        List<SpectrumPeak> candidates = new ArrayList<>();
        for (Scale scale : List.of(coarse, fine)) {
            SpectrumLine line = SpectrumLine.of(spectrum, azimuth, scale.sigmaBins(), tolerance);
            for (int i = 0; i < line.power().length; i++) {
                double x = i * line.step() * Math.cos(azimuth);
                double y = i * line.step() * Math.sin(azimuth);
                if (line.isMaximum(i) && scale.counts(x * spectrum.width(), y * spectrum.height())) {
                    double frequency = i * line.step();
                    double figure = scale.background().figure(x, y, ratio -> line.at(frequency * ratio));
                    candidates.add(new SpectrumPeak(x, y, figure, rmsAround(x, y, scale)));
                }
            }
        }
        return chosen(candidates);
    }

    private Periodicity chosen(List<SpectrumPeak> all) {
        List<SpectrumPeak> candidates = all.stream()
                .filter(peak -> peak.figure() < threshold || !isStaircase(peak))
                .toList();
        double figure =
                candidates.stream().mapToDouble(SpectrumPeak::figure).max().orElse(0);
        List<SpectrumPeak> clear = candidates.stream()
                .filter(peak -> peak.figure() >= threshold)
                .sorted(Comparator.comparingDouble(SpectrumPeak::rms).reversed())
                .toList();
        List<SpectrumPeak> kept = new ArrayList<>();
        for (SpectrumPeak peak : clear) {
            boolean weak = peak.rms() < WEAKEST * clear.get(0).rms();
            if (!weak && kept.stream().noneMatch(stronger -> isOvertone(peak, stronger))) {
                kept.add(peak);
            }
        }
        return new Periodicity(HeightSpectrum.Edges.TAPERED, kept, figure, threshold);
    }

    /**
     * Samples make a staircase of a step or wall that runs aslant. Its spectrum comes back from beyond the sampling frequency as a crest
     * across the others, far weaker than the step, on which chance makes maxima; a period's peak ends in all directions.
     */
    private boolean isStaircase(SpectrumPeak peak) {
        if (peak.rms() * peak.rms() >= STAIRCASE_SHARE * variance) {
            return false;
        }
        if (Math.hypot(peak.frequencyX() * pitchX, peak.frequencyY() * pitchY) > 1 / STAIRCASE_SAMPLES) {
            return true;
        }
        double x = peak.frequencyX() * spectrum.width();
        double y = peak.frequencyY() * spectrum.height();
        Scale scale = fine.counts(x, y) ? fine : coarse;
        for (int i = 0; i < CREST_DIRECTIONS; i++) {
            if (isOnCrest(scale, x, y, Math.PI * i / CREST_DIRECTIONS)) {
                return true;
            }
        }
        return false;
    }

    /** Of a place near the end of the band only one side is known. */
    private static boolean isOnCrest(Scale scale, double x, double y, double direction) {
        double least = CREST_SHARE * scale.smoothed().at((int) Math.rint(x), (int) Math.rint(y));
        int known = 0;
        for (int deviations : CREST_DEVIATIONS) {
            for (int side = -1; side <= 1; side += 2) {
                double away = side * deviations * scale.sigmaBins();
                int besideX = (int) Math.rint(x + away * Math.cos(direction));
                int besideY = (int) Math.rint(y + away * Math.sin(direction));
                if (scale.smoothed().bandX().holds(besideX)
                        && scale.smoothed().bandY().holds(besideY)) {
                    known++;
                    if (scale.smoothed().at(besideX, besideY) < least) {
                        return false;
                    }
                }
            }
        }
        return known >= CREST_DEVIATIONS.length;
    }

    private static boolean isMaximum(HeightSpectrum smoothed, int jx, int jy) {
        double here = smoothed.at(jx, jy);
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                if (smoothed.at(jx + dx, jy + dy) > here) {
                    return false;
                }
            }
        }
        return here > 0;
    }

    private SpectrumPeak refined(Scale scale, int jx, int jy) {
        HeightSpectrum smoothed = scale.smoothed();
        double shiftX = LogParabola.top(smoothed.at(jx - 1, jy), smoothed.at(jx, jy), smoothed.at(jx + 1, jy));
        double shiftY = LogParabola.top(smoothed.at(jx, jy - 1), smoothed.at(jx, jy), smoothed.at(jx, jy + 1));
        double[] bin = sharpened(jx + shiftX, jy + shiftY, 2 * scale.sigmaBins());
        double x = bin[0] / spectrum.width();
        double y = bin[1] / spectrum.height();
        return new SpectrumPeak(x, y, scale.background().figure(x, y), rmsAround(x, y, scale));
    }

    /**
     * The centre of the single line of an exact grating, which neighbours cannot draw aside; the given bin where the
     * power around it is spread.
     */
    private double[] sharpened(double binX, double binY, double radius) {
        int summitX = (int) Math.rint(binX);
        int summitY = (int) Math.rint(binY);
        double all = 0;
        for (int jy = (int) Math.ceil(binY - radius); jy <= binY + radius; jy++) {
            for (int jx = (int) Math.ceil(binX - radius); jx <= binX + radius; jx++) {
                all += spectrum.at(jx, jy);
                if (spectrum.at(jx, jy) > spectrum.at(summitX, summitY)) {
                    summitX = jx;
                    summitY = jy;
                }
            }
        }
        double sum = 0;
        double sumX = 0;
        double sumY = 0;
        for (int jy = summitY - LINE_BINS; jy <= summitY + LINE_BINS; jy++) {
            for (int jx = summitX - LINE_BINS; jx <= summitX + LINE_BINS; jx++) {
                sum += spectrum.at(jx, jy);
                sumX += jx * spectrum.at(jx, jy);
                sumY += jy * spectrum.at(jx, jy);
            }
        }
        return sum > SHARP_SHARE * all ? new double[] {sumX / sum, sumY / sum} : new double[] {binX, binY};
    }

    /** Of the heights whose bins, and their mirror images, lie within two deviations of the average. */
    private double rmsAround(double frequencyX, double frequencyY, Scale scale) {
        double binX = frequencyX * spectrum.width();
        double binY = frequencyY * spectrum.height();
        double radius = 2 * scale.sigmaBins();
        double sum = 0;
        for (int jy = (int) Math.ceil(binY - radius); jy <= binY + radius; jy++) {
            for (int jx = (int) Math.ceil(binX - radius); jx <= binX + radius; jx++) {
                if (Math.hypot(jx - binX, jy - binY) <= radius) {
                    sum += 2 * spectrum.at(jx, jy);
                }
            }
        }
        return Math.sqrt(sum);
    }

    /** Whether a peak is not resolved from another or from a multiple of it. */
    boolean isOvertone(SpectrumPeak peak, SpectrumPeak of) {
        double projection = (peak.frequencyX() * of.frequencyX() + peak.frequencyY() * of.frequencyY())
                / (of.frequency() * of.frequency());
        double multiple = Math.max(1, Math.rint(Math.abs(projection))) * Math.signum(projection);
        double binsX = (peak.frequencyX() - multiple * of.frequencyX()) * spectrum.width();
        double binsY = (peak.frequencyY() - multiple * of.frequencyY()) * spectrum.height();
        return Math.hypot(binsX, binsY) <= 2 * COARSE_BINS;
    }
}
