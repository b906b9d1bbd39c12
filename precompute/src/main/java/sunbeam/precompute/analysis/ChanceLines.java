package sunbeam.precompute.analysis;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.patch.HeightMap;

/**
 * Straight lines that lie where chance wants them, as scratches do. All rows of such a scan say the same, so that it is one
 * profile, whose spectrum has as many maxima as chance makes, and one of them is the highest. A grating's power along the ray
 * from zero frequency through the peak lies in one hump, which the unevenness of its lines or a drift widens; chance's wave
 * holds part of the power around it, and its height comes and goes.
 */
final class ChanceLines {
    // Standard deviation over mean of the wave's local amplitudes: chance's 0.5, uneven gratings' below 0.1.
    private static final double LEAST_CHANGE = 0.12;
    // Half an interval over the period: a phase that keeps step to less is no chance's.
    private static final double LEAST_HALF_WIDTH = 0.03;
    // The hump, over the peak's frequency: what gaps that deviate by 15 % leave; and the bins of a sharp line.
    private static final double HUMP = 0.18;
    private static final double LINE_BINS = 2.5;
    // What is around it, over the peak's frequency: short of its half and its double.
    private static final double FROM = 0.45;
    private static final double TO = 1.6;
    // Of the power around, in the hump: less is chance's, the more so the less the phase keeps step.
    private static final double LEAST_SHARE = 0.8;
    private static final double ENOUGH = 0.92;
    // Bins beside the ray where nothing of it is left.
    private static final double BESIDE = 6;

    private ChanceLines() {}

    /**
     * Whether what is told of a scan's straight lines may be chance's.
     *
     * @param map without missing samples
     * @param peak of its spectrum
     * @param told of that peak
     */
    static boolean in(HeightMap map, SpectrumPeak peak, PeriodEstimate told) {
        double width = told.halfWidth() / told.period();
        if (told.second().isPresent() || !(width > LEAST_HALF_WIDTH)) {
            return false;
        }
        PhaseSeries series = PhaseSeries.of(map, peak.frequencyX(), peak.frequencyY());
        return series.isStraight()
                && change(series.strengths()) > LEAST_CHANGE
                && share(HeightSpectrum.of(map, HeightSpectrum.Edges.TAPERED), peak)
                        < Math.min(ENOUGH, LEAST_SHARE + width);
    }

    private static double change(double[] strengths) {
        double mean = StatUtils.mean(strengths);
        return mean > 0 ? Math.sqrt(StatUtils.populationVariance(strengths, mean)) / mean : 0;
    }

    /** Of the power on the peak's ray around its frequency, the share of the hump that holds most; 0..1. */
    static double share(HeightSpectrum spectrum, SpectrumPeak peak) {
        double bins = bins(spectrum, peak);
        double[] ray = ray(spectrum, peak);
        int first = (int) Math.ceil(FROM * bins);
        int end = Math.min(ray.length, (int) Math.floor(TO * bins) + 1);
        double reach = Math.max(LINE_BINS, HUMP * bins);
        double all = 0;
        double most = 0;
        for (int i = first; i < end; i++) {
            all += ray[i];
            int last = Math.min(end, i + (int) Math.floor(2 * reach) + 1);
            // Another wave, farther away, is not this peak's.
            if (i <= bins && last > bins) {
                most = Math.max(most, Arrays.stream(ray, i, last).sum());
            }
        }
        return all > 0 ? most / all : 1;
    }

    /** Periods of the wave across the scan, along x and y as the sides of a triangle: bins from zero frequency. */
    private static double bins(HeightSpectrum spectrum, SpectrumPeak peak) {
        return Math.hypot(peak.frequencyX() * spectrum.width(), peak.frequencyY() * spectrum.height());
    }

    /** Power along the peak's ray, summed across it, at 0, 1, 2 ... bins, less what noise leaves there. */
    private static double[] ray(HeightSpectrum spectrum, SpectrumPeak peak) {
        double bins = bins(spectrum, peak);
        double cosine = peak.frequencyX() * spectrum.width() / bins;
        double sine = peak.frequencyY() * spectrum.height() / bins;
        double[] ray = new double[(int) Math.ceil(TO * bins) + 2];
        double[] beside = new double[spectrum.power().length];
        int count = 0;
        for (int jy = spectrum.bandY().first(); jy <= spectrum.bandY().last(); jy++) {
            for (int jx = spectrum.bandX().first(); jx <= spectrum.bandX().last(); jx++) {
                double along = jx * cosine + jy * sine;
                double across = Math.abs(jy * cosine - jx * sine);
                int place = (int) Math.floor(along);
                if (along > 0 && place + 1 < ray.length && across <= LINE_BINS) {
                    ray[place] += (place + 1 - along) * spectrum.at(jx, jy);
                    ray[place + 1] += (along - place) * spectrum.at(jx, jy);
                } else if (across > BESIDE && Math.abs(along) < TO * bins) {
                    beside[count++] = spectrum.at(jx, jy);
                }
            }
        }
        Arrays.sort(beside, 0, count);
        // Of exponential statistics: the median over the mean.
        double noise = count == 0 ? 0 : 2 * LINE_BINS * beside[count / 2] / Math.log(2);
        return Arrays.stream(ray).map(power -> Math.max(0, power - noise)).toArray();
    }
}
