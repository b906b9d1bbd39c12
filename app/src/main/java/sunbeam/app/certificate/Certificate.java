package sunbeam.app.certificate;

import java.util.Locale;

/**
 * How far a picture is from the exact one, on random pixels of it.
 *
 * @param pixels how many were evaluated
 * @param relative errors of X, Y, Z ({@link RelativeError#ofColor}) of those of them that are bright enough to be
 *     compared, {@link RelativeError.FLOOR}
 * @param relativeL2 root of the summed squares of all differences by that of all exact values; bright pixels rule it
 * @param colorDifference CIEDE2000 of those compared, after the picture's exposure
 * @param tolerance what was asked for
 */
public record Certificate(
        int pixels, ErrorStatistics relative, double relativeL2, ErrorStatistics colorDifference, double tolerance) {

    /** Whether the median exceeds the tolerance or the 95th percentile three times it. */
    public boolean missed() {
        return !relative.meets(tolerance);
    }

    /** One line with all figures. */
    public String summary() {
        if (relative.count() == 0) {
            return "%d random pixels, all darker than %s: nothing to compare".formatted(pixels, floor());
        }
        return String.format(
                Locale.ROOT,
                "%d random pixels, %d of them above %s: relative error of XYZ %s; relative L2 %.2g; CIEDE2000 median"
                        + " %.2g, maximum %.2g",
                pixels,
                relative.count(),
                floor(),
                relative,
                relativeL2,
                colorDifference.median(),
                colorDifference.maximum());
    }

    /** One line that says what was missed and what helps. */
    public String complaint() {
        return String.format(
                Locale.ROOT,
                "the tolerance %.2g is missed: median %.2g (at most %.2g), 95th percentile %.2g (at most %.2g);"
                        + " ask for a smaller --tolerance, and leave out options that override the plan",
                tolerance,
                relative.median(),
                tolerance,
                relative.percentile95(),
                ErrorStatistics.PERCENTILE_FACTOR * tolerance);
    }

    private static String floor() {
        return String.format(Locale.ROOT, "%.0e", RelativeError.FLOOR);
    }
}
