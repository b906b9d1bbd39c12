package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.text.Text;

/**
 * How far a picture or a table is from the exact one, at random places of it.
 *
 * @param places how many and what were evaluated: 40 random pixels
 * @param complete whether these are all that there are
 * @param quantity what was compared: XYZ or power
 * @param relative errors of those of them that are bright enough to be compared
 * @param colorDifference CIEDE2000 of those compared, after the picture's exposure; of nothing for a table
 * @param limits what was asked for
 */
public record Certificate(
        String places,
        boolean complete,
        String quantity,
        ErrorStatistics relative,
        ErrorStatistics colorDifference,
        Limits limits) {
    /** The same places are evaluated in every run. */
    static final long SEED = 1;

    /**
     * The largest errors that are allowed; infinite where anything is.
     *
     * @param median of the relative errors
     * @param percentile95 of the relative errors
     * @param meanDifference mean CIEDE2000
     */
    public record Limits(double median, double percentile95, double meanDifference) {
        /** Of an anti-aliased picture of a mesh: a CIEDE2000 of 1 is what eyes just tell apart. */
        public static final Limits ANTI_ALIASED = new Limits(0.02, Double.POSITIVE_INFINITY, 1);

        /** A tolerance holds for the median; the 95th percentile may be three times it. */
        public static Limits of(double tolerance) {
            return new Limits(tolerance, ErrorStatistics.PROMISED_PERCENTILE * tolerance, Double.POSITIVE_INFINITY);
        }

        /**
         * Returns the limits of an exported table. Half of its pairs of directions are aimed at orders, on whose flanks it errs
         * by four tolerances at the 95th percentile where orders are sharp; five are allowed.
         */
        public static Limits ofExport(double tolerance) {
            return new Limits(tolerance, 5 * tolerance, Double.POSITIVE_INFINITY);
        }

        /** Whether relative errors keep to these; so do none at all. */
        public boolean hold(ErrorStatistics relative) {
            return relative.count() == 0 || (relative.median() <= median && relative.percentile95() <= percentile95);
        }
    }

    /** @param exposure factor for X, Y, Z before colors are compared */
    static Certificate ofPixels(String places, List<Comparison> compared, double exposure, Limits limits) {
        ErrorStatistics differences = ErrorStatistics.of(compared.stream()
                .filter(Comparison::bright)
                .mapToDouble(pixel -> pixel.colorDifference(exposure))
                .toArray());
        return new Certificate(places, false, "XYZ", Comparison.relative(compared), differences, limits);
    }

    /**
     * Evaluates random rows of a table.
     *
     * @param display shows progress
     * @param rows of the table
     * @param count how many of them; all, when there are fewer
     * @param quantity what its rows hold
     */
    public static Certificate ofRows(
            ProgressDisplay display,
            int rows,
            int count,
            IntFunction<Comparison> row,
            String quantity,
            double tolerance) {
        List<Integer> chosen = new ArrayList<>(IntStream.range(0, rows).boxed().toList());
        Collections.shuffle(chosen, new Random(SEED));
        List<Comparison> compared = display.map("Certificate", chosen.subList(0, Math.min(rows, count)), row::apply);
        boolean all = compared.size() == rows;
        return new Certificate(
                all ? "all " + rows + " rows" : compared.size() + " random rows",
                all,
                quantity,
                Comparison.relative(compared),
                ErrorStatistics.of(),
                Limits.of(tolerance));
    }

    /** Whether a limit is exceeded; not where nothing could be compared. */
    public boolean missed() {
        boolean dark = relative.count() == 0;
        boolean even = colorDifference.count() == 0 || colorDifference.mean() <= limits.meanDifference();
        return !dark && !(limits.hold(relative) && even);
    }

    /** One line with all figures. */
    public String summary() {
        if (relative.count() == 0) {
            return Text.format("%s, all darker than %.0e: nothing to compare", places, Comparison.FLOOR);
        }
        String errors = Text.format(
                "%s, %d of them above %.0e: relative error of %s %s",
                places, relative.count(), Comparison.FLOOR, quantity, relative);
        String colors = colorDifference.count() == 0
                ? ""
                : Text.format(
                        "; CIEDE2000 mean %.2g, median %.2g, maximum %.2g",
                        colorDifference.mean(), colorDifference.median(), colorDifference.maximum());
        return errors + colors + (complete ? "" : relative.doubt());
    }

    /** What was found beside what is allowed: "median 0.02 (at most 0.01)". */
    public String beside() {
        return Stream.of(
                        limited("median", relative.median(), limits.median()),
                        limited("95th percentile", relative.percentile95(), limits.percentile95()),
                        limited("mean CIEDE2000", colorDifference.mean(), limits.meanDifference()))
                .filter(words -> !words.isEmpty())
                .collect(Collectors.joining(", "));
    }

    private static String limited(String what, double value, double limit) {
        return Double.isInfinite(limit) ? "" : Text.format("%s %.2g (at most %.2g)", what, value, limit);
    }
}
