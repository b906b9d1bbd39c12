package sunbeam.precompute.colourtable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.Reach;

/**
 * By how much a table errs beside what it was made of, at random directions that it was not made at: differences of X, Y, Z
 * relative to the largest of them, where that is above {@link ErrorBudget#DARKEST_POWER}.
 *
 * @param count directions that were bright enough
 * @param median of the errors, 0 where there is none
 * @param percentile95 of them
 */
record TableErrors(int count, double median, double percentile95) {
    // Of errors that fall as one over their share, the 95th percentile of so many is known within a tenth.
    private static final int ENOUGH = 2000;
    // Nearly all that a grating shows is dark: so many directions are tried at most.
    private static final int PLACES = 5 * ENOUGH;
    private static final long SEED = 20140607;

    // What the source leaves of a tolerance, of which it may take half, and of the three times that 5 % may exceed.
    // Where
    // errors have a long tail, a certificate of a hundred pixels finds twice the 95th percentile in one of twenty.
    private static final double MEDIAN_SHARE = 0.5;
    private static final double PERCENTILE_SHARE = 1.25;
    // Neither source nor table know colours better than float32.
    private static final double ROUNDING = 1e-5;

    /** Directions that a table may be tried at: of one light the views, evenly as an orthographic map shows them. */
    static List<DirectionPair> places(Reach reach) {
        Random random = new Random(SEED);
        List<DirectionPair> places = new ArrayList<>();
        if (reach instanceof Reach.OneLight one) {
            while (places.size() < PLACES) {
                double x = 2 * random.nextDouble() - 1;
                double y = 2 * random.nextDouble() - 1;
                double height = 1 - x * x - y * y;
                if (height > 0) {
                    places.add(new DirectionPair(one.light(), new Direction(x, y, Math.sqrt(height))));
                }
            }
        } else if (reach instanceof Reach.Pairs some) {
            int all = some.pairs().size();
            for (int i = 0; i < Math.min(all, PLACES); i++) {
                places.add(some.pairs().get(all <= PLACES ? i : random.nextInt(all)));
            }
        }
        return places;
    }

    /** Tries a table, until enough of the directions are bright. */
    static TableErrors of(TableLookUp table, ColourSource source, List<DirectionPair> places) {
        double[] errors = {};
        for (int start = 0; start < places.size() && errors.length < ENOUGH; start += ENOUGH) {
            List<DirectionPair> some = places.subList(start, Math.min(places.size(), start + ENOUGH));
            errors = DoubleStream.concat(Arrays.stream(errors), errors(table, source, some))
                    .toArray();
        }
        return errors.length == 0
                ? new TableErrors(0, 0, 0)
                : new TableErrors(errors.length, Quantiles.of(errors, 0.5), Quantiles.of(errors, 0.95));
    }

    private static DoubleStream errors(TableLookUp table, ColourSource source, List<DirectionPair> places) {
        float[] uvw = new float[3 * places.size()];
        for (int i = 0; i < places.size(); i++) {
            DirectionPair pair = places.get(i);
            uvw[3 * i] = (float) pair.u();
            uvw[3 * i + 1] = (float) pair.v();
            uvw[3 * i + 2] = (float) pair.w();
        }
        float[] exact = source.xyz(uvw);
        return IntStream.range(0, places.size())
                .mapToDouble(i -> relative(table.xyz(places.get(i)), exact, 3 * i))
                .filter(error -> error >= 0);
    }

    /** Negative where there is too little light. */
    private static double relative(double[] xyz, float[] exact, int from) {
        double largest = 0;
        double difference = 0;
        for (int c = 0; c < xyz.length; c++) {
            largest = Math.max(largest, exact[from + c]);
            difference = Math.max(difference, Math.abs(xyz[c] - exact[from + c]));
        }
        return largest > ErrorBudget.DARKEST_POWER ? difference / largest : -1;
    }

    /** How many times what a tolerance allows; up to 1 it is kept. */
    double excess(double tolerance) {
        return Math.max(
                median / Math.max(ROUNDING, MEDIAN_SHARE * tolerance),
                percentile95 / Math.max(ErrorBudget.FLOAT32_PERCENTILE, PERCENTILE_SHARE * tolerance));
    }
}
