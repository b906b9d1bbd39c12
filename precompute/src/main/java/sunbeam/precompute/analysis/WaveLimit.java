package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Waves that a scan without order excludes: straight sines of these periods would have been told, in any direction.
 *
 * @param amplitude least one that the table of decisions does not take for noise, meters
 * @param shortest period, meters; four samples
 * @param longest period, meters; a quarter of the shorter side
 */
public record WaveLimit(double amplitude, double shortest, double longest) {
    private static final int DIRECTIONS = 8;
    private static final int PERIODS = 4;
    private static final double FEWEST = 4;
    // Medians beside a wave vary with its frequency: of 36 waves of 1.5 times the amplitude 32 were told, of twice the
    // amplitude all. KnownSurfaceTest.excludedWavesWouldBeSeen asks a few of them.
    private static final double MARGIN = 2;
    // Ratio of powers, per step.
    private static final double STEP = 1.1;
    private static final int MOST_STEPS = 300;

    /** Empty if the range is, or if a wave of the whole relief would not be told. */
    static Optional<WaveLimit> of(LineMeasures measures, List<SpatialFrequency> tried) {
        HeightMap scan = measures.scan();
        boolean isProfile = Math.min(scan.columns(), scan.rows()) == 1;
        double side = isProfile ? Math.max(scan.width(), scan.height()) : Math.min(scan.width(), scan.height());
        double shortest = Math.max(HeightSpectrum.SHORTEST_PERIOD, FEWEST * Math.max(scan.pitchX(), scan.pitchY()));
        double longest = side / FEWEST;
        double power = 0;
        for (int i = 0; i < PERIODS && longest > shortest; i++) {
            double length = Math.pow(longest / shortest, (double) i / (PERIODS - 1)) / longest;
            for (int k = 0; k < (isProfile ? 1 : DIRECTIONS); k++) {
                double angle = isProfile ? scan.rows() > 1 ? 0.5 * Math.PI : 0 : k * Math.PI / DIRECTIONS;
                SpatialFrequency wave = new SpatialFrequency(length * Math.cos(angle), length * Math.sin(angle));
                power = measures.which().test(wave) ? Math.max(power, least(measures, wave, tried)) : power;
            }
        }
        // A sine's variance is half of its amplitude's square; of opposite lines, one is counted.
        return power > 0 && Double.isFinite(power)
                ? Optional.of(new WaveLimit(MARGIN * Math.sqrt(4 * measures.worth() * power), shortest, longest))
                : Optional.empty();
    }

    /** Returns the peak of the faintest told wave, square meters; noise may have the opposite phase. */
    private static double least(LineMeasures measures, SpatialFrequency wave, List<SpatialFrequency> tried) {
        double noise = measures.top(wave);
        double peak = tried.stream()
                .mapToDouble(other -> measures.top(other) * Math.min(1, other.length() / wave.length()))
                .min()
                .orElse(0);
        peak = Math.max(peak, noise);
        DoubleFunction<Evidence> evidence = measures.evidence(wave);
        for (int i = 0; i < MOST_STEPS && peak > 0; i++) {
            if (Decision.of(evidence.apply(peak)).certainty != GratingPeriod.Certainty.NONE) {
                return Math.pow(Math.sqrt(peak) + Math.sqrt(noise), 2);
            }
            peak *= STEP;
        }
        return Double.POSITIVE_INFINITY;
    }

    String describe() {
        return Text.format(
                "waves of %s to %s would be seen from an amplitude of %s on",
                Lengths.rounded(shortest, 2), Lengths.rounded(longest, 2), Lengths.rounded(amplitude, 2));
    }
}
