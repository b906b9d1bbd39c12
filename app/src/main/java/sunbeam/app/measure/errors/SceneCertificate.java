package sunbeam.app.measure.errors;

import java.util.List;
import java.util.Locale;

/**
 * How far pixels of a picture are from the means of many points in each.
 *
 * @param pixels how many were compared
 * @param relative errors of XYZ ({@link RelativeError}), body and diffracted light together
 * @param meanDifference mean CIEDE2000 after the picture's exposure
 * @param largestDifference the largest
 */
public record SceneCertificate(int pixels, ErrorStatistics relative, double meanDifference, double largestDifference) {
    /** Largest median of the relative errors that an anti-aliased picture may have. */
    public static final double MEDIAN = 0.02;

    /** Largest mean CIEDE2000 that it may have: what eyes just tell apart. */
    public static final double DIFFERENCE = 1;

    /** Of some pixels. */
    static SceneCertificate of(List<Comparison> compared, double exposure) {
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
                compared.size(), Comparison.relative(compared), sum / Math.max(1, compared.size()), largest);
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
                "%s: relative error of XYZ %s; CIEDE2000 mean %.2g, maximum %.2g",
                places,
                relative,
                meanDifference,
                largestDifference);
    }

    /** What was missed. */
    public String complaint() {
        return String.format(
                Locale.ROOT,
                "the picture is not anti-aliased: median error %.2g (at most %.2g), mean CIEDE2000 %.2g (at most %.2g); a larger"
                        + " --supersample helps, or --method table if it was another",
                relative.median(),
                MEDIAN,
                meanDifference,
                DIFFERENCE);
    }
}
