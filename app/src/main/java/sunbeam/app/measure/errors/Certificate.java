package sunbeam.app.measure.errors;

import java.util.Locale;

/**
 * How far a picture or a table is from the exact one, on random places of it.
 *
 * @param places how many and what were evaluated: 40 random pixels
 * @param complete whether these are all that there are
 * @param quantity what was compared: XYZ or power
 * @param relative errors ({@link RelativeError}) of those of them that are bright enough to be compared
 * @param relativeL2 root of the summed squares of all differences by that of all exact values; bright pixels rule it
 * @param colorDifference CIEDE2000 of those compared, after the picture's exposure; of nothing for a table
 * @param tolerance what was asked for
 */
public record Certificate(
        String places,
        boolean complete,
        String quantity,
        ErrorStatistics relative,
        double relativeL2,
        ErrorStatistics colorDifference,
        double tolerance) {

    /** Whether the median exceeds the tolerance or the 95th percentile three times it. */
    public boolean missed() {
        return !relative.meets(tolerance);
    }

    /** One line with all figures. */
    public String summary() {
        if (relative.count() == 0) {
            return String.format(Locale.ROOT, "%s, all darker than %s: nothing to compare", places, floor());
        }
        String errors = String.format(
                Locale.ROOT,
                "%s, %d of them above %s: relative error of %s %s; relative L2 %.2g",
                places,
                relative.count(),
                floor(),
                quantity,
                relative,
                relativeL2);
        String colors = colorDifference.count() == 0
                ? ""
                : String.format(
                        Locale.ROOT,
                        "; CIEDE2000 median %.2g, maximum %.2g",
                        colorDifference.median(),
                        colorDifference.maximum());
        return errors + colors + (complete ? "" : relative.doubt());
    }

    /** What was kept. */
    String praise() {
        return String.format(
                Locale.ROOT,
                "these places keep the tolerance %.2g: the median may be %.2g, the 95th percentile %.2g. That is the error of"
                        + " computing the model; what the model leaves out (docs/theory.md) comes on top",
                tolerance,
                tolerance,
                ErrorStatistics.PERCENTILE_FACTOR * tolerance);
    }

    /** What was missed. */
    public String complaint() {
        return String.format(
                Locale.ROOT,
                "the tolerance %.2g is missed: median %.2g (at most %.2g), 95th percentile %.2g (at most %.2g)",
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
