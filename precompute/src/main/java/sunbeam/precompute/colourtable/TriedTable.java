package sunbeam.precompute.colourtable;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongFunction;
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
    // A finer table that errs nearly as much errs for another reason.
    private static final double IMPROVEMENT = 0.8;

    /**
     * Makes a table.
     *
     * @param tolerance relative error of X, Y, Z that it may add, and its source the same
     * @param reach what is looked at
     * @param coarsest steps to begin with
     * @param pages of a design
     * @param sources opens what evaluates so many places
     * @param room refuses what does not fit, by an exception
     * @param told one line each of what is done again
     */
    public static TriedTable make(
            double tolerance,
            Reach reach,
            TableDesign coarsest,
            Function<TableDesign, TablePages> pages,
            LongFunction<ColourSource> sources,
            Consumer<TablePages> room,
            Consumer<String> told) {
        List<DirectionPair> places = TableErrors.places(reach);
        TableDesign design = coarsest;
        double before = Double.POSITIVE_INFINITY;
        while (true) {
            TablePages made = pages.apply(design);
            TableBaking baking = new TableBaking(made);
            float[][] layers;
            TableErrors errors;
            try (ColourSource source = sources.apply(made.evaluated() + places.size())) {
                layers = baking.layers(source);
                errors = TableErrors.of(new TableLookUp(made, baking, layers), source, places);
            }
            double excess = errors.excess(tolerance);
            boolean hopeless = excess > IMPROVEMENT * before;
            if (excess <= 1 || hopeless) {
                if (excess > 1) {
                    told.accept(inWords(errors, design) + "; smaller steps do not help");
                }
                return new TriedTable(made, baking, baking.texels(layers));
            }
            double factor = Math.pow(excess, -1 / ORDER);
            TableDesign finer = design.finer(Math.max(SMALLEST_FACTOR, Math.min(LARGEST_FACTOR, factor)));
            told.accept(inWords(errors, design)
                    + String.format(Locale.ROOT, "; it is made again in steps of %.2g", finer.step()));
            room.accept(pages.apply(finer));
            design = finer;
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
