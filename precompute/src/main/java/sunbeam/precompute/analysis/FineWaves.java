package sunbeam.precompute.analysis;

import java.util.List;
import sunbeam.precompute.patch.HeightMap;

/**
 * Waves finer than light sees that hold much of the heights' variance. Nobody looks for their periods, but overtones of them
 * that the samples cannot hold come back as others, sharp and coarse, which are no waves of the surface.
 */
final class FineWaves {
    // Of the heights' variance, beyond what light sees: before that, nothing is looked for there.
    private static final double MUCH_BEYOND = 0.25;
    // Of the variance, in a line.
    private static final double LEAST_SHARE = 0.05;
    // Of the lines' variance together: a wave of less is as likely something that they have left.
    private static final double RESIDUE = 0.05;
    // Multiples of the lines' frequencies that are followed, both together.
    private static final int MOST_MULTIPLES = 10;
    private static final int MOST_LINES = 3;
    private static final double SAME_BINS = 1.5;

    private final HeightMap map;
    private final List<SpectrumPeak> lines;

    private FineWaves(HeightMap map, List<SpectrumPeak> lines) {
        this.map = map;
        this.lines = lines;
    }

    /**
     * Of a scan without missing samples.
     *
     * @param seen its tapered spectrum up to what light sees
     */
    static FineWaves of(HeightMap map, HeightSpectrum seen) {
        if (!HeightSpectrum.endsBeforeSamplesDo(map) || seen.shareBeyond() < MUCH_BEYOND) {
            return new FineWaves(map, List.of());
        }
        HeightSpectrum whole = HeightSpectrum.ofAllFrequencies(map);
        return new FineWaves(map, new SharpLines(whole).beyond(HeightSpectrum.HIGHEST_FREQUENCY, LEAST_SHARE));
    }

    /** Whether a wave may be an alias that the fine ones have left. */
    boolean mayHaveLeft(SpectrumPeak peak) {
        if (lines.isEmpty()) {
            return false;
        }
        double variance =
                lines.stream().mapToDouble(line -> line.rms() * line.rms()).sum();
        return peak.rms() * peak.rms() < RESIDUE * variance || isAlias(peak);
    }

    private boolean isAlias(SpectrumPeak peak) {
        int used = Math.min(MOST_LINES, lines.size());
        for (int i = 0; i < used; i++) {
            for (int j = i; j < used; j++) {
                if (isAliasOfTwo(peak, lines.get(i), lines.get(j))) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isAliasOfTwo(SpectrumPeak peak, SpectrumPeak first, SpectrumPeak second) {
        for (int m = -MOST_MULTIPLES; m <= MOST_MULTIPLES; m++) {
            int most = MOST_MULTIPLES - Math.abs(m);
            for (int n = -most; n <= most; n++) {
                double x = folded(m * first.frequencyX() + n * second.frequencyX(), map.pitchX());
                double y = folded(m * first.frequencyY() + n * second.frequencyY(), map.pitchY());
                double away = Math.hypot((peak.frequencyX() - x) * map.width(), (peak.frequencyY() - y) * map.height());
                if (away < SAME_BINS && isFolded(m, n, first, second)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Beyond what the samples hold: others are true waves of the surface. */
    private boolean isFolded(int m, int n, SpectrumPeak first, SpectrumPeak second) {
        return Math.abs(m * first.frequencyX() + n * second.frequencyX()) * map.pitchX() > 0.5
                || Math.abs(m * first.frequencyY() + n * second.frequencyY()) * map.pitchY() > 0.5;
    }

    private static double folded(double frequency, double pitch) {
        return Math.IEEEremainder(frequency * pitch, 1) / pitch;
    }
}
