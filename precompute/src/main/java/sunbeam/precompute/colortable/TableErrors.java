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
 * Errors of a table against its source at random directions: differences of X, Y, Z relative to the largest of them, where that or the
 * table's is above {@link ErrorBudget#DARKEST_POWER}. False light is measured relative to that power; NaN counts as infinite, as in
 * certificates.
 *
 * @param count number of bright directions
 * @param median of the errors, 0 if there are none
 */
public record TableErrors(int count, double median, double percentile95, double percentile98) {
    // For errors with a tail of 1 / share, this many fix the 95th percentile within a tenth.
    static final int ENOUGH = 2000;

    // The source may err by half the tolerance, so the table by the other half, and by 1.25 of the promised 3
    // tolerances. With long tails a
    // certificate of a hundred pixels finds twice the 95th percentile in one of twenty.
    static final double PROMISED_PERCENTILE = 3;
    private static final double MEDIAN_SHARE = 0.5;
    private static final double PERCENTILE_SHARE = 1.25;
    // Bounds the 98th percentile as well, so that samples of fifty directions rarely exceed the limit three times (one
    // of twelve).
    private static final double PERCENTILE_98_SHARE = 3;
    // Float32's limit, for table and source.
    private static final double ROUNDING = 2e-5;
    private static final double ROUNDING_PERCENTILE = 2 * ErrorBudget.FLOAT32_PERCENTILE;

    /**
     * Compares a table at directions, until enough of them are bright.
     *
     * @param table X, Y, Z of the table
     * @param exact direct baker
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

    /** Returns the relative error; negative if both are dark. */
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

    static double largest(double[] xyz) {
        return Arrays.stream(xyz).max().orElse(0);
    }

    /** True if the errors keep the promise, possibly with less margin than a table should have. */
    public boolean meet(double tolerance) {
        return median <= tolerance && percentile95 <= PROMISED_PERCENTILE * tolerance;
    }

    /** Returns the ratio to the allowed errors; up to 1 the tolerance is kept. */
    double excess(double tolerance) {
        double tail = Math.max(
                percentile95 / Math.max(ROUNDING_PERCENTILE, PERCENTILE_SHARE * tolerance),
                percentile98 / Math.max(ROUNDING_PERCENTILE, PERCENTILE_98_SHARE * tolerance));
        return Math.max(median / Math.max(ROUNDING, MEDIAN_SHARE * tolerance), tail);
    }
}
