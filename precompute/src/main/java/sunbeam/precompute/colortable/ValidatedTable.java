package sunbeam.precompute.colortable;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.Reach;
import sunbeam.precompute.shader.TableArray;

/**
 * A table that has been tried. The laws of {@link TableDesign} are measured, and there are surfaces for which they are too
 * coarse: between the tails of sharp orders, seen at one place, roots of colors have lines of kinks. So a table is tried at
 * directions that it was not made at, and made again with smaller steps until it keeps its tolerance.
 *
 * @param tiles where its texels lie
 * @param baking that made them
 * @param texels of all slices
 * @param trial what was found, for people
 */
public record ValidatedTable(TableTiles tiles, TableBaking baking, TableArray texels, String trial) {
    // Errors fall with the fourth to sixth power of the step; at kinks more slowly.
    private static final double ORDER = 4;
    private static final double SMALLEST_FACTOR = 0.5;
    // Smaller changes would not show whether they help.
    private static final double LARGEST_FACTOR = 0.75;
    // Two tables, each finer than the one before, of which the last errs nearly as much err for another reason. One
    // does not
    // tell: of few directions the 95th percentile jumps.
    private static final double IMPROVEMENT = 0.8;

    /** Opens what evaluates colors. */
    @FunctionalInterface
    public interface Sources {
        /**
         * A source, to be closed by the caller.
         *
         * @param design of the table that is made of it
         * @param places that will be asked for in all
         */
        ColorSource open(TableDesign design, long places);
    }

    /** Takes a line about what is done otherwise than planned. */
    public interface Told {
        /** What takes longer. */
        void delay(String line);

        /** What remains less sure than asked for. */
        void shortfall(String line);
    }

    /**
     * Makes a table.
     *
     * @param tolerance relative error of X, Y, Z that it may add, and its source the same
     * @param reach what is looked at
     * @param coarsest steps to begin with
     * @param tiles of a design
     * @param sources opens what evaluates places
     * @param room whether tiles fit
     * @param refused throws what is said of tiles that do not fit and are needed
     * @param told one line each of what takes longer than planned, or falls short
     */
    public static ValidatedTable make(
            double tolerance,
            Reach reach,
            TableDesign coarsest,
            Function<TableDesign, TableTiles> tiles,
            Sources sources,
            Predicate<TableTiles> room,
            Consumer<TableTiles> refused,
            Told told) {
        List<DirectionPair> places = TableErrors.places(reach);
        TableTiles next = tiles.apply(coarsest);
        double before = Double.POSITIVE_INFINITY;
        double beforeThat = Double.POSITIVE_INFINITY;
        while (true) {
            TableTiles made = next;
            TableBaking baking = new TableBaking(made);
            float[][] layers;
            TableErrors errors;
            try (ColorSource source = sources.open(made.design(), made.evaluated() + places.size())) {
                layers = baking.layers(source);
                errors = TableErrors.of(new TableLookUp(made, baking, layers), source, places);
            }
            double excess = errors.excess(tolerance);
            String words = inWords(errors, made, tolerance);
            ValidatedTable tried = new ValidatedTable(made, baking, baking.texels(layers), words);
            if (excess <= 1) {
                return tried;
            }
            if (!(excess < IMPROVEMENT * beforeThat) || Double.isInfinite(excess)) {
                told.shortfall("table: " + words + "; smaller steps do not help");
                return tried;
            }
            double factor = Math.pow(excess, -1 / ORDER);
            next = tiles.apply(made.design().scaled(Math.max(SMALLEST_FACTOR, Math.min(LARGEST_FACTOR, factor))));
            if (!room.test(next)) {
                if (!errors.meet(tolerance)) {
                    refused.accept(next);
                }
                told.shortfall("table: " + words
                        + ", which is closer to the limit than it should be: for smaller steps there is no room");
                return tried;
            }
            told.delay(String.format(
                    Locale.ROOT,
                    "table: %s, too close to that or beyond it; it is made again in steps of %.2g",
                    words,
                    next.design().step()));
            beforeThat = before;
            before = excess;
        }
    }

    private static String inWords(TableErrors errors, TableTiles tiles, double tolerance) {
        String steps = String.format(
                Locale.ROOT, "steps of %.2g in (u, v)", tiles.design().step());
        if (tiles.slices() > 1) {
            steps += String.format(Locale.ROOT, ", %d slices in w", tiles.slices());
        }
        return errors.count() == 0
                ? steps + ", tried where light goes: nowhere, all directions are dark"
                : String.format(
                        Locale.ROOT,
                        "%s, tried at %d directions: errs by %.2g in the median, %.2g at the 95th and %.2g at the 98th percentile"
                                + " beside what it was made of (%.2g in the median and %.2g at the 95th are promised of both together)",
                        steps,
                        errors.count(),
                        errors.median(),
                        errors.percentile95(),
                        errors.percentile98(),
                        tolerance,
                        TableErrors.PROMISED_PERCENTILE * tolerance);
    }
}
