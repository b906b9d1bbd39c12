package sunbeam.precompute.patch;

import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;

/**
 * Whether a surface is flat enough for scalar theory, which takes every point for a mirror that shifts the phase and
 * knows neither shadows nor second reflections.
 */
public final class SlopeCheck {
    /**
     * Steepest slope that passes, degrees. Light from the normal leaves a facet of 30 degrees 60 degrees off the normal,
     * where the next rise of the same slope just lets it pass; steeper ones shadow each other and reflect twice.
     */
    public static final double STEEPEST = 30;

    /** Largest share of steeper surface that passes without a word: the walls of a grating take less. */
    public static final double LARGEST_SHARE = 0.02;

    private SlopeCheck() {}

    /**
     * A warning when more than {@link #LARGEST_SHARE} of the surface is steeper than {@link #STEEPEST}. The seam between
     * repetitions of the patch is not looked at: it is no measured slope.
     *
     * @param map without missing samples
     */
    public static Optional<String> slopes(HeightMap map) {
        long steep = 0;
        double limit = Math.tan(Math.toRadians(STEEPEST));
        int columns = Math.max(1, map.columns() - 1);
        int rows = Math.max(1, map.rows() - 1);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double slope = slope(map, column, row);
                steep += slope > limit ? 1 : 0;
            }
        }
        double share = steep / ((double) columns * rows);
        return share <= LARGEST_SHARE ? Optional.empty() : Optional.of(warning(share, ModelError.of(map)));
    }

    /** The slope between a sample and its right and lower neighbors. */
    static double slope(HeightMap map, int column, int row) {
        double here = map.at(column, row);
        double alongX = map.columns() > 1 ? (map.at(column + 1, row) - here) / map.pitchX() : 0;
        double alongY = map.rows() > 1 ? (map.at(column, row + 1) - here) / map.pitchY() : 0;
        return Math.sqrt(alongX * alongX + alongY * alongY);
    }

    private static String warning(double share, ModelError error) {
        return String.format(
                Locale.ROOT,
                "slopes too steep for scalar theory: %.1f %% of the surface are steeper than %.0f degrees, and %s of the light is"
                        + " drawn elsewhere than it goes (docs/theory.md)",
                100 * share,
                STEEPEST,
                error.share());
    }
}
