package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.plan.ErrorBudget;

/**
 * Errors of a mesh's table at some of a picture's footprints.
 *
 * @param all footprints bright enough to count
 * @param darker half of them
 * @param brighter half of them
 */
public record FootprintErrors(TableErrors all, TableErrors darker, TableErrors brighter) {
    private record Compared(double error, double power) {}

    /**
     * Compares colors.
     *
     * @param computed X, Y, Z of power of each footprint
     * @param exact the same without a table
     */
    public static FootprintErrors of(List<double[]> computed, List<double[]> exact) {
        List<Compared> lit = new ArrayList<>();
        for (int i = 0; i < exact.size(); i++) {
            double error = TableErrors.relative(computed.get(i), exact.get(i));
            if (error >= 0) {
                lit.add(new Compared(error, TableErrors.largest(exact.get(i))));
            }
        }
        lit.sort(Comparator.comparingDouble(Compared::power));
        int half = lit.size() / 2;
        return new FootprintErrors(errors(lit), errors(lit.subList(0, half)), errors(lit.subList(half, lit.size())));
    }

    /** True if X, Y, Z of power are bright enough to count. */
    public static boolean isBright(double[] xyz) {
        return TableErrors.largest(xyz) > ErrorBudget.DARKEST_POWER;
    }

    private static TableErrors errors(List<Compared> some) {
        return TableErrors.of(some.stream().mapToDouble(Compared::error).toArray());
    }

    /** Returns a warning if a tolerance is missed. */
    public Optional<String> miss(double tolerance) {
        return all.meet(tolerance)
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "the table of colors errs by %.2g in the median and %.2g at the 95th percentile of %d samples of this picture"
                                + " (%.2g and %.2g are promised). Medians of its darker half: %.2g, of its brighter half: %.2g. A finer tolerance errs"
                                + " by less; method full has no table",
                        all.median(),
                        all.percentile95(),
                        all.count(),
                        tolerance,
                        TableErrors.PROMISED_PERCENTILE * tolerance,
                        darker.median(),
                        brighter.median()));
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "median %.2g, 95th percentile %.2g at %d samples",
                all.median(),
                all.percentile95(),
                all.count());
    }
}
