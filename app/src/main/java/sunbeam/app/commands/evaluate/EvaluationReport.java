package sunbeam.app.commands.evaluate;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.PeriodStatistics;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.RidgeSearch;
import sunbeam.precompute.units.Lengths;

/** The figures of an evaluation: for people as lines, for programs as a tree of names and values (docs/evaluation.md). */
final class EvaluationReport {
    // Other ridges, beside the strongest, that are told of.
    private static final int RIDGES = 8;
    private static final int RIDGE_DIGITS = 5;
    private static final double NANOMETRES = 1e9;

    private EvaluationReport() {}

    /** What was found. */
    static Map<String, Object> tree(GratingMeasurement measurement) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("order", measurement.order());
        tree.put("peaks_interpolated", statistics(measurement.interpolated()));
        tree.put("peaks_on_samples", statistics(measurement.sampled()));
        List<Map<String, Object>> ridges = new ArrayList<>();
        for (RidgeSearch.Candidate candidate : firstRidges(measurement)) {
            Map<String, Object> ridge = new LinkedHashMap<>();
            ridge.put("period_nm", candidate.period() * NANOMETRES);
            ridge.put("mean_response", candidate.strength());
            ridges.add(ridge);
        }
        tree.put("ridges", ridges);
        return tree;
    }

    private static List<RidgeSearch.Candidate> firstRidges(GratingMeasurement measurement) {
        List<RidgeSearch.Candidate> all = measurement.candidates();
        return all.subList(0, Math.min(RIDGES, all.size()));
    }

    private static Map<String, Object> statistics(PeriodStatistics statistics) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("mean_nm", statistics.mean() * NANOMETRES);
        tree.put("variance_nm2", statistics.variance() * NANOMETRES * NANOMETRES);
        tree.put("standard_error_nm", statistics.standardError() * NANOMETRES);
        tree.put("wavelengths", statistics.count());
        return tree;
    }

    /** Angles in degrees, wavelengths in nm: first, last, number. */
    static Map<String, Object> tree(ResponseGrid grid) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("theta_i_degrees", Math.toDegrees(grid.plane().thetaI()));
        tree.put("phi_i_degrees", Math.toDegrees(grid.plane().phiI()));
        tree.put("azimuth_degrees", Math.toDegrees(grid.plane().azimuth()));
        tree.put("angles_degrees", range(grid.angles(), Math.toDegrees(1)));
        tree.put("wavelengths_nm", range(grid.wavelengths(), NANOMETRES));
        return tree;
    }

    private static Map<String, Object> range(double[] values, double unit) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("first", values[0] * unit);
        tree.put("last", values[values.length - 1] * unit);
        tree.put("count", values.length);
        return tree;
    }

    /** The period that the heights tell. */
    static Map<String, Object> tree(GratingPeriod period) {
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

    /** For people: what the heights tell, or why they do not. */
    static String line(GratingTarget target) {
        return target.told()
                .map(told -> "period      " + told.describe() + ", of the heights: "
                        + (told.isExact()
                                ? "the patch repeats"
                                : String.format(
                                        Locale.ROOT,
                                        "it is seen %.1f times and explains %.0f %% of their variance",
                                        told.periods(),
                                        100 * told.share())))
                .orElseGet(() -> "period      not told: " + target.doubt());
    }

    static Map<String, Object> tree(Positions positions, long seed) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("count", positions.places().size());
        tree.put("with_a_ridge", positions.sorted().length);
        tree.put("seed", seed);
        tree.put("method", "bins");
        tree.put("ensemble_nm", finite(positions.ensemble()));
        tree.put("mean_nm", finite(positions.mean()));
        tree.put("standard_deviation_nm", finite(positions.deviation()));
        tree.put("minimum_nm", finite(positions.quantile(0)));
        tree.put("lower_quartile_nm", finite(positions.quantile(0.25)));
        tree.put("median_nm", finite(positions.quantile(0.5)));
        tree.put("upper_quartile_nm", finite(positions.quantile(0.75)));
        tree.put("maximum_nm", finite(positions.quantile(1)));
        return tree;
    }

    /** JSON knows no NaN. */
    private static Double finite(double metres) {
        return Double.isFinite(metres) ? metres * NANOMETRES : null;
    }

    /**
     * Where the brightest ridge is: without digits that nobody should quote where no period is told.
     *
     * @param area whose ridge it is
     */
    static String ridgeLine(GratingMeasurement measurement, boolean told, String area) {
        return String.format(
                Locale.ROOT,
                "ridge       %s, the brightest of %s over %d wavelengths, order %d: where light goes, not how well the period is known",
                Lengths.rounded(measurement.interpolated().mean(), told ? RIDGE_DIGITS : 2),
                area,
                measurement.interpolated().count(),
                measurement.order());
    }

    /** The thesis's figures of Table 4.1, and other ridges. */
    static List<String> lines(GratingMeasurement measurement) {
        List<String> lines = new ArrayList<>();
        lines.add("                        mean d     variance  standard error  wavelengths");
        lines.add(line("peaks interpolated", measurement.interpolated()));
        lines.add(line("peaks on samples", measurement.sampled()));
        List<RidgeSearch.Candidate> ridges = firstRidges(measurement);
        if (ridges.size() > 1) {
            StringBuilder others = new StringBuilder("weaker ridges at");
            for (RidgeSearch.Candidate ridge : ridges.subList(1, ridges.size())) {
                others.append(String.format(
                        Locale.ROOT,
                        " %.0f nm (%.2g)",
                        ridge.period() * NANOMETRES,
                        ridge.strength() / ridges.get(0).strength()));
            }
            lines.add(others.append(" of the strongest's brightness").toString());
        }
        return lines;
    }

    private static String line(String name, PeriodStatistics statistics) {
        return String.format(
                Locale.ROOT,
                "%-20s %9.2f nm  %7.2g nm2      %7.1g nm       %6d",
                name,
                statistics.mean() * NANOMETRES,
                statistics.variance() * NANOMETRES * NANOMETRES,
                statistics.standardError() * NANOMETRES,
                statistics.count());
    }

    static List<String> lines(Positions positions) {
        return List.of(
                String.format(
                        Locale.ROOT,
                        "%d positions of the window: %.1f to %.1f nm, quartiles %.1f, %.1f, %.1f nm, mean %.1f +- %.1f nm",
                        positions.places().size(),
                        positions.quantile(0) * NANOMETRES,
                        positions.quantile(1) * NANOMETRES,
                        positions.quantile(0.25) * NANOMETRES,
                        positions.quantile(0.5) * NANOMETRES,
                        positions.quantile(0.75) * NANOMETRES,
                        positions.mean() * NANOMETRES,
                        positions.deviation() * NANOMETRES),
                String.format(
                        Locale.ROOT, "mean response over all positions: %.2f nm", positions.ensemble() * NANOMETRES));
    }
}
