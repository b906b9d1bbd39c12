package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.ErrorBudget;

/** Errors of a table against its source at random directions, and their ratio to the allowed errors. */
final class TableErrors {
    // Bright directions to compare; they determine the 95th percentile to a tenth.
    static final int ENOUGH = 2000;

    // Allowed median and 95th percentile of the table's errors, in tolerances. Source and table may err by half the
    // tolerance each in the median. If errors have a long tail, one of twenty certificates of a hundred pixels measures
    // twice the percentile, so that the table may have 1.25 of the 3 tolerances promised.
    private static final double MEDIAN_SHARE = 0.5;
    private static final double PERCENTILE_SHARE = 1.25;
    // The same for the 98th percentile: then one of twelve samples of fifty directions has three errors above the
    // limit.
    private static final double PERCENTILE_98_SHARE = 3;
    // Allowed at any tolerance, since float32 causes them.
    private static final double ROUNDING = 2e-5;
    private static final double ROUNDING_PERCENTILE = 2 * ErrorBudget.FLOAT32_PERCENTILE;

    private TableErrors() {}

    /** Returns the relative errors at the first samples, until {@link #ENOUGH} of them are bright. */
    static ErrorStatistics of(
            Function<DirectionPair, double[]> table, ColorBaker exact, BakeToken token, List<DirectionPair> samples) {
        List<Comparison> bright = new ArrayList<>();
        for (int start = 0; start < samples.size() && bright.size() < ENOUGH; start += ENOUGH) {
            List<DirectionPair> batch = samples.subList(start, Math.min(samples.size(), start + ENOUGH));
            float[] uvw = new float[3 * batch.size()];
            for (int i = 0; i < batch.size(); i++) {
                DirectionPair pair = batch.get(i);
                uvw[3 * i] = (float) pair.u();
                uvw[3 * i + 1] = (float) pair.v();
                uvw[3 * i + 2] = (float) pair.w();
            }
            float[] xyz = exact.bake(uvw, token);
            for (int i = 0; i < batch.size(); i++) {
                Comparison one = new Comparison(table.apply(batch.get(i)), Comparison.xyz(xyz, i), 1);
                if (one.bright()) {
                    bright.add(one);
                }
            }
        }
        return Comparison.relative(bright);
    }

    /** Returns the largest ratio of an error to the allowed one: at most 1 if the tolerance is kept; 0 if there are no errors. */
    static double excess(ErrorStatistics errors, double tolerance) {
        if (errors.count() == 0) {
            return 0;
        }
        double tail = Math.max(
                errors.percentile95() / Math.max(ROUNDING_PERCENTILE, PERCENTILE_SHARE * tolerance),
                errors.percentile98() / Math.max(ROUNDING_PERCENTILE, PERCENTILE_98_SHARE * tolerance));
        return Math.max(errors.median() / Math.max(ROUNDING, MEDIAN_SHARE * tolerance), tail);
    }
}
