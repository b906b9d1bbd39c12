package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.ErrorBudget;

/** Compares a table with its source at random directions, and says how much of a tolerance its errors take. */
final class TableErrors {
    // For errors with a tail of 1 / share, this many fix the 95th percentile within a tenth.
    static final int ENOUGH = 2000;

    // The source may err by half the tolerance, so the table by the other half, and by 1.25 of the promised 3
    // tolerances. With long tails a certificate of a hundred pixels finds twice the 95th percentile in one of twenty.
    private static final double MEDIAN_SHARE = 0.5;
    private static final double PERCENTILE_SHARE = 1.25;
    // Bounds the 98th percentile as well, so that samples of fifty directions rarely exceed the limit three times (one
    // of twelve).
    private static final double PERCENTILE_98_SHARE = 3;
    // Float32's limit, for table and source.
    private static final double ROUNDING = 2e-5;
    private static final double ROUNDING_PERCENTILE = 2 * ErrorBudget.FLOAT32_PERCENTILE;

    private TableErrors() {}

    /**
     * Compares a table at directions, until enough of them are bright.
     *
     * @param table X, Y, Z of the table
     * @param exact direct baker
     */
    static ErrorStatistics of(
            Function<DirectionPair, double[]> table, ColorBaker exact, BakeToken token, List<DirectionPair> samples) {
        List<Comparison> bright = new ArrayList<>();
        for (int start = 0; start < samples.size() && bright.size() < ENOUGH; start += ENOUGH) {
            List<DirectionPair> some = samples.subList(start, Math.min(samples.size(), start + ENOUGH));
            float[] uvw = new float[3 * some.size()];
            for (int i = 0; i < some.size(); i++) {
                DirectionPair pair = some.get(i);
                uvw[3 * i] = (float) pair.u();
                uvw[3 * i + 1] = (float) pair.v();
                uvw[3 * i + 2] = (float) pair.w();
            }
            float[] xyz = exact.bake(uvw, token);
            for (int i = 0; i < some.size(); i++) {
                Comparison one = new Comparison(table.apply(some.get(i)), Comparison.xyz(xyz, i), 1);
                if (one.bright()) {
                    bright.add(one);
                }
            }
        }
        return Comparison.relative(bright);
    }

    /** Returns the ratio of errors to the allowed ones; up to 1, or without errors, the tolerance is kept. */
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
