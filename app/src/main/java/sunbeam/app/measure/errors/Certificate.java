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
 * Errors of a picture or a table against the exact reference, at random pixels or rows.
 *
 * @param places description of the evaluated pixels or rows, such as "40 random pixels"
 * @param complete whether all pixels or rows were evaluated
 * @param quantity compared quantity: XYZ or power
 * @param relative relative errors of the pixels or rows that are bright enough
 * @param colorDifference CIEDE2000 of the same pixels after the picture's exposure; empty for a table
 */
public record Certificate(
        String places,
        boolean complete,
        String quantity,
        ErrorStatistics relative,
        ErrorStatistics colorDifference,
        Limits limits) {
    /** Seed of the random pixels or rows, so that each run chooses the same. */
    static final long SEED = 1;

    /** Largest allowed errors, of the relative errors and of mean CIEDE2000; infinite for no limit. */
    public record Limits(double median, double percentile95, double meanDifference) {
        /** A CIEDE2000 of 1 is just visible. */
        public static final Limits ANTI_ALIASED = new Limits(0.02, Double.POSITIVE_INFINITY, 1);

        /** Returns the limits of a tolerance: the median may reach it, the 95th percentile three times it. */
        public static Limits of(double tolerance) {
            return new Limits(tolerance, ErrorStatistics.PERCENTILE_95_LIMIT * tolerance, Double.POSITIVE_INFINITY);
        }

        /**
         * Returns the limits of an exported table. Half of the compared pairs of directions are aimed at orders. On their steep flanks the
         * 95th percentile of the table's errors is four to nine tolerances; ten are allowed.
         */
        public static Limits ofExport(double tolerance) {
            return new Limits(tolerance, 10 * tolerance, Double.POSITIVE_INFINITY);
        }

        /** True if the errors are within the limits, or if there are none. */
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

    /** Evaluates {@code count} random rows of a table, at most all, made for this tolerance; {@code row} compares one by its number. */
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

    public boolean missed() {
        boolean dark = relative.count() == 0;
        boolean even = colorDifference.count() == 0 || colorDifference.mean() <= limits.meanDifference();
        return !dark && !(limits.hold(relative) && even);
    }

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

    /** Returns each limited error with its limit: "median 0.02 (at most 0.01)". */
    public String comparison() {
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
