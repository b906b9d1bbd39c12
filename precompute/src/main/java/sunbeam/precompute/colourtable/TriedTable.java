package sunbeam.precompute.colourtable;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.Reach;
import sunbeam.precompute.shader.TableArray;

/**
 * A table that has been tried. The laws of {@link TableDesign} are measured, and there are surfaces for which they are too
 * coarse: between the tails of sharp orders, seen at one place, roots of colours have lines of kinks. So a table is tried at
 * directions that it was not made at, and made again with smaller steps until it keeps its tolerance.
 *
 * @param pages where its texels lie
 * @param baking that made them
 * @param texels of all slices
 */
public record TriedTable(TablePages pages, TableBaking baking, TableArray texels) {
    // Errors fall with the fourth to sixth power of the step; at kinks more slowly.
    private static final double ORDER = 4;
    private static final double SMALLEST_FACTOR = 0.5;
    // Smaller changes would not show whether they help.
    private static final double LARGEST_FACTOR = 0.75;
    // Two tables, each finer than the one before, of which the last errs nearly as much err for another reason. One
    // does not
    // tell: of few directions the 95th percentile jumps.
    private static final double IMPROVEMENT = 0.8;

    /**
     * Makes a table.
     *
     * @param tolerance relative error of X, Y, Z that it may add, and its source the same
     * @param reach what is looked at
     * @param coarsest steps to begin with
     * @param pages of a design
     * @param sources opens what evaluates so many places
     * @param room whether pages fit
     * @param refused throws what is said of pages that do not fit and are needed
     * @param told one line each of what is done otherwise than planned
     */
    public static TriedTable make(
            double tolerance,
            Reach reach,
            TableDesign coarsest,
            Function<TableDesign, TablePages> pages,
            LongFunction<ColourSource> sources,
            Predicate<TablePages> room,
            Consumer<TablePages> refused,
            Consumer<String> told) {
        List<DirectionPair> places = TableErrors.places(reach);
        TablePages next = pages.apply(coarsest);
        double before = Double.POSITIVE_INFINITY;
        double beforeThat = Double.POSITIVE_INFINITY;
        while (true) {
            TablePages made = next;
            TableBaking baking = new TableBaking(made);
            float[][] layers;
            TableErrors errors;
            try (ColourSource source = sources.apply(made.evaluated() + places.size())) {
                layers = baking.layers(source);
                errors = TableErrors.of(new TableLookUp(made, baking, layers), source, places);
            }
            double excess = errors.excess(tolerance);
            if (excess <= 1) {
                return new TriedTable(made, baking, baking.texels(layers));
            }
            String words = inWords(errors, made.design());
            if (!(excess < IMPROVEMENT * beforeThat) || Double.isInfinite(excess)) {
                told.accept(words + "; smaller steps do not help");
                return new TriedTable(made, baking, baking.texels(layers));
            }
            double factor = Math.pow(excess, -1 / ORDER);
            next = pages.apply(made.design().finer(Math.max(SMALLEST_FACTOR, Math.min(LARGEST_FACTOR, factor))));
            if (!room.test(next)) {
                if (!errors.meet(tolerance)) {
                    refused.accept(next);
                }
                told.accept(words + ", less certainly than it should: for smaller steps there is no room");
                return new TriedTable(made, baking, baking.texels(layers));
            }
            told.accept(words
                    + String.format(
                            Locale.ROOT,
                            "; it is made again in steps of %.2g",
                            next.design().step()));
            beforeThat = before;
            before = excess;
        }
    }

    private static String inWords(TableErrors errors, TableDesign design) {
        return String.format(
                Locale.ROOT,
                "in steps of %.2g in (u, v) a table of these colours errs by %.2g in the median and %.2g at the 95th percentile of %d"
                        + " directions",
                design.step(),
                errors.median(),
                errors.percentile95(),
                errors.count());
    }
}
