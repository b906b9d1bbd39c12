package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.ErrorBudget;

/**
 * By how much a table errs beside what it was made of, at random directions that it was not made at: differences of X, Y, Z
 * relative to the largest of them, where that or the table's is above {@link ErrorBudget#DARKEST_POWER}. Light where there should
 * be none is measured by that power, and what is no number errs infinitely, as in certificates.
 *
 * @param count directions that were bright enough
 * @param median of the errors, 0 where there is none
 * @param percentile95 of them
 * @param percentile98 of them
 */
public record TableErrors(int count, double median, double percentile95, double percentile98) {
    // Of errors that fall as one over their share, the 95th percentile of so many is known within a tenth.
    static final int ENOUGH = 2000;

    // What the source leaves of a tolerance, of which it may take half, and of the three times that 5 % may exceed.
    // Where
    // errors have a long tail, a certificate of a hundred pixels finds twice the 95th percentile in one of twenty.
    static final double PROMISED_PERCENTILE = 3;
    private static final double MEDIAN_SHARE = 0.5;
    private static final double PERCENTILE_SHARE = 1.25;
    // As few may exceed what 5 % may, lest samples of fifty directions find three in more than one of twelve.
    private static final double PERCENTILE_98_SHARE = 3;
    // Neither source nor table know colors better than float32 does, and both err.
    private static final double ROUNDING = 2e-5;
    private static final double ROUNDING_PERCENTILE = 2 * ErrorBudget.FLOAT32_PERCENTILE;

    /**
     * Compares a table at directions, until enough of them are bright.
     *
     * @param table X, Y, Z that it has
     * @param exact bakes each sample by itself
     */
    static TableErrors of(
            Function<DirectionPair, double[]> table, ColorBaker exact, BakeToken token, List<DirectionPair> samples) {
        double[] errors = {};
        for (int start = 0; start < samples.size() && errors.length < ENOUGH; start += ENOUGH) {
            List<DirectionPair> some = samples.subList(start, Math.min(samples.size(), start + ENOUGH));
            errors = DoubleStream.concat(Arrays.stream(errors), errors(table, exact, token, some))
                    .toArray();
        }
        return of(errors);
    }

    /** Of errors in any order. */
    static TableErrors of(double[] errors) {
        return errors.length == 0
                ? new TableErrors(0, 0, 0, 0)
                : new TableErrors(
                        errors.length,
                        Quantiles.of(errors, 0.5),
                        Quantiles.of(errors, 0.95),
                        Quantiles.of(errors, 0.98));
    }

    private static DoubleStream errors(
            Function<DirectionPair, double[]> table, ColorBaker exact, BakeToken token, List<DirectionPair> samples) {
        float[] uvw = new float[3 * samples.size()];
        for (int i = 0; i < samples.size(); i++) {
            DirectionPair pair = samples.get(i);
            uvw[3 * i] = (float) pair.u();
            uvw[3 * i + 1] = (float) pair.v();
            uvw[3 * i + 2] = (float) pair.w();
        }
        float[] xyz = exact.bake(uvw, token);
        return IntStream.range(0, samples.size())
                .mapToDouble(i -> relative(
                        table.apply(samples.get(i)), new double[] {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}))
                .filter(error -> error >= 0);
    }

    /** Negative where there is too little light. */
    static double relative(double[] computed, double[] exact) {
        double difference = 0;
        for (int c = 0; c < exact.length; c++) {
            difference = Math.max(difference, Math.abs(computed[c] - exact[c]));
        }
        if (Double.isNaN(difference)) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(largest(exact), largest(computed)) > ErrorBudget.DARKEST_POWER
                ? difference / Math.max(ErrorBudget.DARKEST_POWER, largest(exact))
                : -1;
    }

    /** Of X, Y and Z. */
    static double largest(double[] xyz) {
        return Arrays.stream(xyz).max().orElse(0);
    }

    /** Whether they keep what a tolerance promises, if with less to spare than a table should. */
    public boolean meet(double tolerance) {
        return median <= tolerance && percentile95 <= PROMISED_PERCENTILE * tolerance;
    }

    /** How many times what a tolerance allows; up to 1 it is kept. */
    double excess(double tolerance) {
        double tail = Math.max(
                percentile95 / Math.max(ROUNDING_PERCENTILE, PERCENTILE_SHARE * tolerance),
                percentile98 / Math.max(ROUNDING_PERCENTILE, PERCENTILE_98_SHARE * tolerance));
        return Math.max(median / Math.max(ROUNDING, MEDIAN_SHARE * tolerance), tail);
    }
}
