package sunbeam.precompute.patch;

import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Slopes of a surface and the expected error of scalar theory: the sum over all directions of the absolute difference from Maxwell's
 * equations, relative to the reflected light. It is a power law of the mean slope, fitted to 1500 gratings by rigorous coupled-wave
 * analysis (docs/theory.md, docs/examples/coupled_waves.py).
 *
 * @param meanSlope mean of |grad h|; for a grating twice its depth over its period
 * @param rmsSlope root mean square of |grad h| (Sdq of ISO 25178)
 * @param steepShare share of the surface, 0..1, that is steeper than {@link #STEEPEST}
 */
public record ModelError(double meanSlope, double rmsSlope, double largestSlope, double steepShare) {
    /** Largest mean slope of the power law; beyond it, half of the light or more is drawn in wrong directions. */
    public static final double LARGEST_SLOPE = 1.2;

    /** Degrees: the next rise of the same slope just lets light from the normal pass; steeper facets shadow each other. */
    public static final double STEEPEST = 30;

    // Share of steeper surface without a warning: the walls of a grating take less.
    private static final double LARGEST_SHARE = 0.02;
    // Expected error without a warning: a grating of low ridges has steep walls, too.
    private static final double LEAST_ERROR = 0.1;

    /**
     * Angles of the light to the normal (0 to 30, 30 to 60, 60 to 75 degrees) with the law factor * meanSlope^exponent; {@code low} and
     * {@code high} times it enclose eight of ten gratings.
     */
    public enum Incidence {
        NEAR_NORMAL(0.742, 1.271, 0.36, 2.46),
        OBLIQUE(0.754, 0.757, 0.43, 2.37),
        GRAZING(1.063, 0.738, 0.33, 2.25);

        private final double factor;
        private final double exponent;
        private final double low;
        private final double high;

        Incidence(double factor, double exponent, double low, double high) {
            this.factor = factor;
            this.exponent = exponent;
            this.low = low;
            this.high = high;
        }
    }

    /** The slopes of a period include those at the border to the next one. */
    public static ModelError of(HeightMap map, Patch.Repetition repetition) {
        return of(map, repetition, false).orElseThrow();
    }

    /** Leaves out slopes beside missing samples; if this leaves none, as of a checkerboard, takes those of the filled map. */
    static ModelError of(HeightMap map, HeightMap filled, Patch.Repetition repetition) {
        return of(map, repetition, true).orElseGet(() -> of(filled, repetition));
    }

    /** @param hasGaps whether slopes that are not finite are left out; empty if none is left */
    private static Optional<ModelError> of(HeightMap map, Patch.Repetition repetition, boolean hasGaps) {
        // Rounding must not make exactly 30 degrees steeper.
        double limit = Math.tan(Math.toRadians(STEEPEST)) * (1 + 1e-9);
        double sum = 0;
        double squares = 0;
        double largest = 0;
        double steep = 0;
        double count = 0;
        int last = repetition == Patch.Repetition.PERIODIC ? 0 : 1;
        int columns = Math.max(1, map.columns() - last);
        int rows = Math.max(1, map.rows() - last);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double slope = slope(map, column, row);
                if (hasGaps && !Double.isFinite(slope)) {
                    continue;
                }
                count++;
                sum += slope;
                squares += slope * slope;
                largest = Math.max(largest, slope);
                steep += slope > limit ? 1 : 0;
            }
        }
        return count == 0
                ? Optional.empty()
                : Optional.of(new ModelError(sum / count, Math.sqrt(squares / count), largest, steep / count));
    }

    private static double slope(HeightMap map, int column, int row) {
        double here = map.at(column, row);
        double alongX = (map.at((column + 1) % map.columns(), row) - here) / map.pitchX();
        double alongY = (map.at(column, (row + 1) % map.rows()) - here) / map.pitchY();
        return Math.sqrt(alongX * alongX + alongY * alongY);
    }

    double expected(Incidence incidence) {
        return incidence.factor * Math.pow(meanSlope, incidence.exponent);
    }

    double low(Incidence incidence) {
        return incidence.low * expected(incidence);
    }

    double high(Incidence incidence) {
        return incidence.high * expected(incidence);
    }

    Optional<String> warning() {
        if (steepShare <= LARGEST_SHARE || expected(Incidence.NEAR_NORMAL) < LEAST_ERROR) {
            return Optional.empty();
        }
        String share =
                meanSlope <= LARGEST_SLOPE ? "about " + percent(expected(Incidence.NEAR_NORMAL)) : "half or more";
        return Optional.of(Text.format(
                "slopes too steep for scalar theory: %.1f %% of the surface are steeper than %.0f degrees, and %s of the light is"
                        + " drawn in wrong directions (docs/theory.md)",
                100 * steepShare, STEEPEST, share));
    }

    public String describe() {
        String slope = "mean slope " + Decimals.rounded(meanSlope, 2);
        if (meanSlope > LARGEST_SLOPE) {
            return slope + ", beyond the rule: about half of the light is drawn in wrong directions (docs/theory.md)";
        }
        return "about " + percent(expected(Incidence.NEAR_NORMAL))
                + " of the reflected light is drawn in wrong directions ("
                + percent(low(Incidence.NEAR_NORMAL)) + " to " + percent(high(Incidence.NEAR_NORMAL))
                + ") with light up to 30 degrees from the normal, " + percent(expected(Incidence.OBLIQUE))
                + " up to 60, " + percent(expected(Incidence.GRAZING)) + " up to 75 (" + slope + "; docs/theory.md)";
    }

    private static String percent(double share) {
        return share >= 1 ? "all" : Decimals.rounded(100 * share, 2) + " %";
    }
}
