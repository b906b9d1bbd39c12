package sunbeam.app.commands.evaluate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.apache.commons.math3.stat.descriptive.StatisticalSummary;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.Ridge;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** An evaluation as lines for people, and as a tree of names and values and a table for programs (docs/evaluation.md). */
record EvaluationReport(Evaluation evaluation) {
    private static final int RIDGE_DIGITS = 5;
    private static final double NANOMETRES = 1e9;

    /**
     * What stands below the verdict.
     *
     * @param area what of the surface the ridge belongs to
     * @param explained whether the thesis's figures of Table 4.1 are asked for
     */
    List<String> lines(String area, boolean explained) {
        GratingPeriod heights = evaluation.heights();
        List<String> lines = new ArrayList<>();
        lines.add(evaluation.title(evaluation.patch().name()));
        lines.add("period      "
                + (heights.isTold()
                        ? heights.describe()
                        : "not told: " + heights.refusal().orElseThrow()));
        evaluation.noRidge().ifPresent(why -> lines.add("ridge       left out: " + why));
        evaluation.ridge().ifPresent(ridge -> {
            StatisticalSummary periods = ridge.statistics();
            // Digits that nobody should quote are left out where no period is told.
            lines.add(Text.format(
                    "ridge       %s, the brightest of %s over %d wavelengths, order %d: where light goes, not how well the period is known",
                    Lengths.rounded(periods.getMean(), heights.isTold() ? RIDGE_DIGITS : 2),
                    area,
                    periods.getN(),
                    ridge.order()));
            if (explained) {
                lines.add(Text.format(
                        "            mean %.2f nm, variance %.2g nm2, standard error %.1g nm over the wavelengths",
                        periods.getMean() * NANOMETRES,
                        periods.getVariance() * NANOMETRES * NANOMETRES,
                        standardError(periods) * NANOMETRES));
            }
        });
        return lines;
    }

    private static double standardError(StatisticalSummary periods) {
        return Math.sqrt(periods.getVariance() / periods.getN());
    }

    /** Verdict, period, light and axes, ridge. */
    Map<String, Object> tree() {
        GratingPeriod heights = evaluation.heights();
        ResponseGrid grid = evaluation.response().grid();
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("verdict", Verdict.of(evaluation.patch(), heights));
        tree.put("period", heights.isTold() ? tree(heights) : null);
        tree.put("period_not_told", heights.refusal().orElse(null));
        tree.put("theta_i_degrees", Math.toDegrees(grid.plane().thetaI()));
        tree.put("phi_i_degrees", Math.toDegrees(grid.plane().phiI()));
        tree.put("azimuth_degrees", Math.toDegrees(grid.plane().azimuth()));
        tree.put("angles_degrees", range(grid.angles(), Math.toDegrees(1)));
        tree.put("wavelengths_nm", range(grid.wavelengths(), NANOMETRES));
        tree.put("ridge_left_out", evaluation.noRidge().orElse(null));
        evaluation.ridge().ifPresent(ridge -> {
            tree.put("order", ridge.order());
            tree.put("peaks_interpolated", tree(ridge));
        });
        return tree;
    }

    private static Map<String, Object> tree(Ridge ridge) {
        StatisticalSummary periods = ridge.statistics();
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("mean_nm", periods.getMean() * NANOMETRES);
        tree.put("variance_nm2", periods.getVariance() * NANOMETRES * NANOMETRES);
        tree.put("standard_error_nm", standardError(periods) * NANOMETRES);
        tree.put("wavelengths", periods.getN());
        return tree;
    }

    private static Map<String, Object> range(double[] values, double unit) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("first", values[0] * unit);
        tree.put("last", values[values.length - 1] * unit);
        tree.put("count", values.length);
        return tree;
    }

    private static Map<String, Object> tree(GratingPeriod period) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("nm", period.period() * NANOMETRES);
        tree.put("low_nm", period.low() * NANOMETRES);
        tree.put("high_nm", period.high() * NANOMETRES);
        tree.put("probability", GratingPeriod.PROBABILITY);
        tree.put("direction_degrees", Math.toDegrees(period.azimuth()));
        tree.put("direction_half_width_degrees", Math.toDegrees(period.azimuthHalfWidth()));
        tree.put("periods_in_the_scan", period.isExact() ? null : period.periods());
        tree.put("share_of_variance", period.share());
        return tree;
    }

    /** One row per wavelength: the wavelength in nm, then the response at each angle, which heads its column. */
    AtomicFile.StreamContent csv() {
        ResponseGrid grid = evaluation.response().grid();
        List<String> header = new ArrayList<>(List.of("wavelength_nm"));
        for (double angle : grid.angles()) {
            header.add(Text.format("%.6f", Math.toDegrees(angle)));
        }
        return CsvWriter.numbers(
                header,
                grid.wavelengths().length,
                row -> DoubleStream.concat(
                                DoubleStream.of(grid.wavelengths()[row] * NANOMETRES),
                                Arrays.stream(evaluation.response().values()[row]))
                        .toArray());
    }
}
