package sunbeam.app.measure.errors;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * How far pixels of a picture are from the means of many points in each.
 *
 * @param pixels how many were compared
 * @param relative errors of XYZ ({@link RelativeError}), body and diffracted light together
 * @param meanDifference mean CIEDE2000 after the picture's exposure
 * @param largestDifference the largest
 * @param diffracting errors where more than {@link #DIFFRACTING} of the light is diffracted; empty where that was not looked at
 */
public record SceneCertificate(
        int pixels,
        ErrorStatistics relative,
        double meanDifference,
        double largestDifference,
        Optional<ErrorStatistics> diffracting) {
    /** Largest median of the relative errors that an anti-aliased picture may have. */
    public static final double MEDIAN = 0.02;

    /** Largest mean CIEDE2000 that it may have: what eyes just tell apart. */
    public static final double DIFFERENCE = 1;

    /** Share of a pixel's luminance: beside as much, errors of a body that is drawn exactly hide little. */
    static final double DIFFRACTING = 0.1;

    /** Of some pixels. */
    static SceneCertificate of(List<Comparison> compared, double exposure) {
        return of(compared, exposure, Optional.empty());
    }

    /**
     * Of some pixels.
     *
     * @param diffracting those of them of whose light more than {@link #DIFFRACTING} is diffracted
     */
    static SceneCertificate of(List<Comparison> compared, double exposure, List<Comparison> diffracting) {
        return of(compared, exposure, Optional.of(Comparison.relative(diffracting)));
    }

    private static SceneCertificate of(
            List<Comparison> compared, double exposure, Optional<ErrorStatistics> diffracting) {
        double[] differences = compared.stream()
                .mapToDouble(pixel -> pixel.colorDifference(exposure))
                .toArray();
        double sum = 0;
        double largest = 0;
        for (double difference : differences) {
            sum += difference;
            largest = Math.max(largest, difference);
        }
        return new SceneCertificate(
                compared.size(),
                Comparison.relative(compared),
                sum / Math.max(1, compared.size()),
                largest,
                diffracting);
    }

    /** Whether the picture is further from the means than it may be. */
    public boolean missed() {
        // Written so that a NaN is a miss; of no pixels nothing is said.
        boolean even = relative.count() == 0 || relative.median() <= MEDIAN;
        return pixels > 0 && !(even && meanDifference <= DIFFERENCE);
    }

    /** One line with all figures. */
    public String summary() {
        if (pixels == 0) {
            return "no pixel is filled by the mesh: nothing to compare";
        }
        String places = String.format(
                Locale.ROOT,
                "%d random pixels that the mesh fills, beside the mean of %d points in each",
                pixels,
                SceneCertifier.POINTS * SceneCertifier.POINTS);
        if (relative.count() == 0) {
            return String.format(
                    Locale.ROOT, "%s: all are darker than %.0e, nothing to compare", places, RelativeError.FLOOR);
        }
        return String.format(
                Locale.ROOT,
                "%s: relative error of XYZ %s; CIEDE2000 mean %.2g, maximum %.2g%s%s",
                places,
                relative,
                meanDifference,
                largestDifference,
                diffracting.map(this::ofDiffracted).orElse(""),
                relative.doubt());
    }

    private String ofDiffracted(ErrorStatistics some) {
        if (some.count() == 0) {
            return "; in none of them is more than a tenth of the light diffracted";
        }
        if (some.count() == relative.count()) {
            return "; in all of them more than a tenth of the light is diffracted";
        }
        return String.format(
                Locale.ROOT,
                "; in %d of them, where more than a tenth of the light is diffracted, %s%s",
                some.count(),
                some,
                some.doubt().isEmpty() ? "" : ", which are few: give more places");
    }

    /** What was kept. */
    public String praise() {
        return String.format(
                Locale.ROOT,
                "the picture is anti-aliased: the median may be %.2g, the mean CIEDE2000 %.2g",
                MEDIAN,
                DIFFERENCE);
    }

    /** What was missed. */
    public String complaint() {
        return String.format(
                Locale.ROOT,
                "the picture is not anti-aliased: median error %.2g (at most %.2g), mean CIEDE2000 %.2g (at most %.2g)",
                relative.median(),
                MEDIAN,
                meanDifference,
                DIFFERENCE);
    }
}
