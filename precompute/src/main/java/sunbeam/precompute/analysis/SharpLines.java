package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The line of a grating in the spectrum of a piece of a surface, where that holds much of the heights' variance: as sharp
 * as the piece allows, so that no average over bins is needed to see it and few periods are enough.
 */
final class SharpLines {
    /** How many times the line's top exceeds the median of the bins around. The largest of 200 bins of noise does 10 times. */
    static final double THRESHOLD = 100;

    // Of the variance, in the line.
    private static final double LEAST_SHARE = 0.25;
    // Of the variance, in each of many lines and in all of them; along more than one direction.
    private static final double LEAST_SHARE_OF_MANY = 0.005;
    private static final double LEAST_SHARE_TOGETHER = 0.4;
    // A Hann window spreads one frequency over two bins on each side.
    private static final int LINE_BINS = 2;
    private static final int SURROUNDINGS = 8;
    private static final double FEWEST_PERIODS = 3.7;

    // Of fewer periods, overtones lie among the bins beside the line.
    private static final double FEWEST_OF_RAY = 12;
    // Beyond the line's own bins, before its overtones.
    private static final int RAY_FIRST = 3;
    private static final int RAY_LAST = 6;
    private static final double OUT_OF_RAY = 10;

    // Of a lattice's other waves: their heights against the strongest's, and how many are told.
    private static final double LEAST_ACROSS = 0.3;
    private static final int MOST_ACROSS = 3;
    private static final int HIGHEST_OVERTONE = 12;
    // Between an overtone of the strongest and a line that is it.
    private static final double SAME_BINS = 1.5;

    private final HeightSpectrum spectrum;

    SharpLines(HeightSpectrum spectrum) {
        this.spectrum = spectrum;
    }

    /**
     * The strongest line, where there is one.
     *
     * @param variance of the heights less their plane, square metres
     */
    Optional<SpectrumPeak> strongest(double variance) {
        return strongest(LEAST_SHARE * variance, FEWEST_PERIODS);
    }

    /**
     * The strongest line of those that hold more than others.
     *
     * @param variance of the others, square metres
     * @param fewest of its periods across the patch
     */
    Optional<SpectrumPeak> strongest(double variance, double fewest) {
        return tops(variance, fewest).stream()
                .filter(peak -> fewest < FEWEST_OF_RAY || standsOutAlongItsRay(peak))
                .max(Comparator.comparingDouble(SpectrumPeak::rms));
    }

    /**
     * The strongest of many lines that hold most of the heights' variance together, each of them less than a single grating's: those of
     * a lattice of dots, which are the narrower the more there are.
     *
     * @param variance of the heights less their plane, square metres
     */
    Optional<SpectrumPeak> strongestOfMany(double variance) {
        List<SpectrumPeak> lines = tops(LEAST_SHARE_OF_MANY * variance, FEWEST_PERIODS).stream()
                .filter(peak -> standsOutAlongItsRay(peak))
                .toList();
        double together =
                lines.stream().mapToDouble(peak -> peak.rms() * peak.rms()).sum();
        return lines.stream()
                .max(Comparator.comparingDouble(SpectrumPeak::rms))
                .filter(first -> together >= LEAST_SHARE_TOGETHER * variance
                        && lines.stream().anyMatch(first::isAcross));
    }

    /**
     * Lines of a frequency or higher, the strongest first.
     *
     * @param frequency cycles per metre
     * @param share of the variance, in each
     */
    List<SpectrumPeak> beyond(double frequency, double share) {
        double variance = Arrays.stream(spectrum.power()).sum();
        return tops(share * variance, FEWEST_PERIODS).stream()
                .filter(peak -> peak.frequency() > frequency)
                .sorted(Comparator.comparingDouble(SpectrumPeak::rms).reversed())
                .toList();
    }

    private List<SpectrumPeak> tops(double variance, double fewest) {
        List<int[]> tops = new ArrayList<>();
        for (int jy = 0; jy <= spectrum.bandY().last(); jy++) {
            int first = jy == 0 ? 1 : spectrum.bandX().first();
            for (int jx = first; jx <= spectrum.bandX().last(); jx++) {
                if (2 * sumAround(jx, jy, 0) > 0.05 * variance && Math.hypot(jx, jy) >= fewest && isTop(jx, jy)) {
                    tops.add(new int[] {jx, jy});
                }
            }
        }
        return tops.stream()
                .map(top -> peak(top[0], top[1]))
                .filter(peak -> peak.figure() >= THRESHOLD && peak.rms() * peak.rms() >= variance)
                .toList();
    }

    /**
     * Lines in other directions than the strongest, which a lattice has, the strongest first; not its overtones that come back from beyond
     * the sampling frequency.
     *
     * @param pitchX distance of the heights' samples along x, metres
     * @param pitchY and along y
     */
    List<SpectrumPeak> across(SpectrumPeak first, double pitchX, double pitchY) {
        double variance = LEAST_ACROSS * LEAST_ACROSS * first.rms() * first.rms();
        List<SpectrumPeak> found = new ArrayList<>();
        tops(variance, FEWEST_PERIODS).stream()
                .filter(peak -> !isOvertone(peak, first, pitchX, pitchY))
                .sorted(Comparator.comparingDouble(SpectrumPeak::rms).reversed())
                .forEach(peak -> {
                    boolean another =
                            Stream.concat(Stream.of(first), found.stream()).allMatch(peak::isAcross);
                    if (another && found.size() < MOST_ACROSS) {
                        found.add(peak);
                    }
                });
        return found;
    }

    private boolean isOvertone(SpectrumPeak peak, SpectrumPeak of, double pitchX, double pitchY) {
        for (int multiple = 2; multiple <= HIGHEST_OVERTONE; multiple++) {
            double x = Math.IEEEremainder(multiple * of.frequencyX() * pitchX, 1) / pitchX;
            double y = Math.IEEEremainder(multiple * of.frequencyY() * pitchY, 1) / pitchY;
            for (int sign = -1; sign <= 1; sign += 2) {
                if (Math.hypot(
                                (peak.frequencyX() - sign * x) * spectrum.width(),
                                (peak.frequencyY() - sign * y) * spectrum.height())
                        < SAME_BINS) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Whether a line is more than what lies before and behind it in the same direction. The whole spectrum of a step or of terraces is one
     * such ray, on which every bin stands far above its surroundings.
     */
    private boolean standsOutAlongItsRay(SpectrumPeak peak) {
        double x = peak.frequencyX() * spectrum.width();
        double y = peak.frequencyY() * spectrum.height();
        double bins = Math.hypot(x, y);
        double[] beside = new double[2 * (RAY_LAST - RAY_FIRST + 1)];
        for (int i = 0; i < beside.length; i++) {
            int distance = (i % 2 == 0 ? 1 : -1) * (RAY_FIRST + i / 2);
            beside[i] = largestAround(x + distance * x / bins, y + distance * y / bins);
        }
        Arrays.sort(beside);
        return largestAround(x, y) >= OUT_OF_RAY * beside[beside.length / 2];
    }

    private double largestAround(double x, double y) {
        double largest = 0;
        for (int jy = (int) Math.rint(y) - 1; jy <= Math.rint(y) + 1; jy++) {
            for (int jx = (int) Math.rint(x) - 1; jx <= Math.rint(x) + 1; jx++) {
                largest = Math.max(largest, spectrum.at(jx, jy));
            }
        }
        return largest;
    }

    /** The sharp line at a frequency, to a bin; empty where there is none, or it is no clear one. */
    Optional<SpectrumPeak> at(double frequencyX, double frequencyY) {
        int jx = (int) Math.rint(frequencyX * spectrum.width());
        int jy = (int) Math.rint(frequencyY * spectrum.height());
        for (int y = jy - 1; y <= jy + 1; y++) {
            for (int x = jx - 1; x <= jx + 1; x++) {
                if (Math.hypot(x, y) >= FEWEST_PERIODS && isTop(x, y)) {
                    return Optional.of(peak(x, y)).filter(peak -> peak.figure() >= THRESHOLD);
                }
            }
        }
        return Optional.empty();
    }

    private boolean isTop(int jx, int jy) {
        double here = spectrum.at(jx, jy);
        for (int dy = -LINE_BINS; dy <= LINE_BINS; dy++) {
            for (int dx = -LINE_BINS; dx <= LINE_BINS; dx++) {
                if (spectrum.at(jx + dx, jy + dy) > here) {
                    return false;
                }
            }
        }
        return here > 0;
    }

    private double sumAround(int jx, int jy, int reach) {
        double sum = 0;
        for (int y = jy - reach; y <= jy + reach; y++) {
            for (int x = jx - reach; x <= jx + reach; x++) {
                sum += spectrum.at(x, y);
            }
        }
        return sum;
    }

    private SpectrumPeak peak(int jx, int jy) {
        double sum = 0;
        double sumX = 0;
        double sumY = 0;
        for (int y = jy - LINE_BINS; y <= jy + LINE_BINS; y++) {
            for (int x = jx - LINE_BINS; x <= jx + LINE_BINS; x++) {
                sum += spectrum.at(x, y);
                sumX += x * spectrum.at(x, y);
                sumY += y * spectrum.at(x, y);
            }
        }
        return new SpectrumPeak(
                sumX / sum / spectrum.width(),
                sumY / sum / spectrum.height(),
                spectrum.at(jx, jy) / surroundings(jx, jy),
                Math.sqrt(2 * sum));
    }

    /** The median of the bins around the line, without those around zero frequency and without the line's own. */
    private double surroundings(int jx, int jy) {
        double[] found = new double[(2 * SURROUNDINGS + 1) * (2 * SURROUNDINGS + 1)];
        int count = 0;
        for (int y = jy - SURROUNDINGS; y <= jy + SURROUNDINGS; y++) {
            for (int x = jx - SURROUNDINGS; x <= jx + SURROUNDINGS; x++) {
                boolean line = Math.max(Math.abs(x - jx), Math.abs(y - jy)) <= LINE_BINS;
                boolean inside = Math.abs(x) <= spectrum.bandX().last()
                        && Math.abs(y) <= spectrum.bandY().last();
                if (!line && inside && Math.hypot(x, y) > LINE_BINS) {
                    found[count++] = spectrum.at(x, y);
                }
            }
        }
        Arrays.sort(found, 0, count);
        // Exact gratings leave nothing beside their lines.
        return count == 0 ? Double.MIN_NORMAL : Math.max(found[count / 2], 1e-9 * spectrum.at(jx, jy));
    }
}
