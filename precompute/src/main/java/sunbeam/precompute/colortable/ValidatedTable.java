package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.shader.ShaderTables;

/**
 * A table for points, of one level, that has been validated. The laws of {@link TableDesign} are measured, and there are surfaces for which
 * they are too coarse: between the tails of sharp orders, seen at one place, roots of colors have lines of kinks. So a table is compared
 * with what it is made of at directions that it was not made at, and made again with smaller steps until it keeps its tolerance.
 *
 * @param grid of its texels
 * @param numbers of its coefficients
 * @param cells with its tiles
 * @param errors that were found
 */
public record ValidatedTable(TileGrid grid, NumberFormat numbers, TileCells cells, TableErrors errors) {
    // Errors fall with the fourth to sixth power of the step; at kinks more slowly.
    private static final double ORDER = 4;
    private static final double SMALLEST_FACTOR = 0.5;
    // Smaller changes would not show whether they help.
    private static final double LARGEST_FACTOR = 0.75;
    // Two tables, each finer than the one before, of which the last errs nearly as much err for another reason. One
    // does not tell: of few
    // directions the 95th percentile jumps.
    private static final double IMPROVEMENT = 0.8;
    private static final String CLOSE = ", which is closer to the limit than it should be";

    /**
     * Take a line each about what is done otherwise than planned.
     *
     * @param note what takes longer, or is close to the tolerance
     * @param shortfall what misses the tolerance
     */
    public record Told(Consumer<String> note, Consumer<String> shortfall) {}

    /**
     * The finest level of a table of all lights, if all tiles that are looked into are cached and keep the table's tolerance.
     *
     * @param cached tiles of the table
     * @param bakers as of {@link #make}
     * @param tokens as of {@link #make}
     */
    public static Optional<ValidatedTable> cached(
            ColorTable levels,
            TablePoints points,
            CachedTiles cached,
            Function<TableDesign, ColorBaker> bakers,
            LongFunction<BakeToken> tokens) {
        TileGrid grid = TileGrid.of(levels.levels().get(0));
        BitSet tiles = points.tiles(grid);
        if (!cached.present(0, tiles).equals(tiles)) {
            return Optional.empty();
        }
        Map<Integer, byte[]> read = cached.read(0, tiles);
        if (read.size() < tiles.cardinality()) {
            return Optional.empty();
        }
        TileCells cells = new TileCells(List.of(grid), levels.numbers());
        read.forEach((tile, coefficients) -> cells.add(0, tile, coefficients));
        List<DirectionPair> samples = points.samples();
        try (ColorBaker baker = bakers.apply(grid.design());
                BakeToken token = tokens.apply(samples.size())) {
            ValidatedTable table = of(grid, levels.numbers(), cells, baker, token, samples);
            return Optional.of(table).filter(made -> made.errors.excess(levels.tolerance()) <= 1);
        }
    }

    private static ValidatedTable of(
            TileGrid grid,
            NumberFormat numbers,
            TileCells cells,
            ColorBaker baker,
            BakeToken token,
            List<DirectionPair> samples) {
        TableLookUp lookUp = new TableLookUp(List.of(grid), numbers, cells::coefficient);
        TableErrors errors =
                TableErrors.of(pair -> lookUp.xyz(0, pair.u(), pair.v(), pair.w()), baker.direct(), token, samples);
        return new ValidatedTable(grid, numbers, cells, errors);
    }

    private static ValidatedTable made(
            TileGrid grid,
            BitSet tiles,
            Function<TableDesign, ColorBaker> bakers,
            LongFunction<BakeToken> tokens,
            List<DirectionPair> samples) {
        LevelBaking baking = new LevelBaking(grid, NumberFormat.FLOAT);
        TileCells cells = new TileCells(List.of(grid), NumberFormat.FLOAT);
        try (ColorBaker baker = bakers.apply(grid.design());
                BakeToken token = tokens.apply(baking.missing(tiles) + samples.size())) {
            Iterator<byte[]> coefficients = baking.bake(tiles, baker, token).iterator();
            tiles.stream().forEach(tile -> cells.add(0, tile, coefficients.next()));
            return of(grid, NumberFormat.FLOAT, cells, baker, token, samples);
        }
    }

    /**
     * Makes a table.
     *
     * @param tolerance relative error of X, Y, Z that it may add, and its source the same
     * @param points what is looked at
     * @param coarsest steps to begin with
     * @param bakers opens the baker for a design, to be closed by the caller
     * @param tokens opens the token for a number of samples, to be closed by the caller
     * @param room whether a table fits
     * @param refused throws what is said of a table that does not fit and is needed
     * @param told one line each of what takes longer than planned, or falls short
     */
    public static ValidatedTable make(
            double tolerance,
            TablePoints points,
            TableDesign coarsest,
            Function<TableDesign, ColorBaker> bakers,
            LongFunction<BakeToken> tokens,
            Predicate<MemoryNeed> room,
            Consumer<TableDesign> refused,
            Told told) {
        List<DirectionPair> samples = points.samples();
        TableDesign next = coarsest;
        double before = Double.POSITIVE_INFINITY;
        double beforeThat = Double.POSITIVE_INFINITY;
        while (true) {
            TileGrid grid = points.grid(next);
            ValidatedTable table = made(grid, points.tiles(grid), bakers, tokens, samples);
            double excess = table.errors.excess(tolerance);
            String words = table.words(tolerance);
            if (excess <= 1) {
                return table;
            }
            if (!(excess < IMPROVEMENT * beforeThat) || Double.isInfinite(excess)) {
                if (table.errors.meet(tolerance)) {
                    told.note().accept("table: " + words + CLOSE + "; smaller steps do not help");
                } else {
                    told.shortfall().accept("table: " + words + "; smaller steps do not help");
                }
                return table;
            }
            double factor = Math.pow(excess, -1 / ORDER);
            next = next.scaled(Math.max(SMALLEST_FACTOR, Math.min(LARGEST_FACTOR, factor)));
            if (!room.test(points.memory(next))) {
                if (!table.errors.meet(tolerance)) {
                    refused.accept(next);
                }
                told.note().accept("table: " + words + CLOSE + ": for smaller steps there is no room");
                return table;
            }
            told.note()
                    .accept(String.format(
                            Locale.ROOT,
                            "table: %s, too close to that or beyond it; it is made again in steps of %.2g",
                            words,
                            next.step()));
            beforeThat = before;
            before = excess;
        }
    }

    /** What was found, for people. */
    public String words(double tolerance) {
        String steps = String.format(
                Locale.ROOT, "steps of %.2g in (u, v)", grid.design().step());
        if (grid.slices() > 1) {
            steps += String.format(Locale.ROOT, ", %d slices in w", grid.slices());
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

    /** Puts it into what a shader reads (shaders/method/table.glsl). */
    public void putInto(ShaderTables.Builder tables) {
        cells.putInto(tables);
        TileCells.define(tables, grid)
                .define("COLOR_FILTER", grid.interpolation().shaderFunction())
                .define("COLOR_ONE_LIGHT", grid.space() instanceof TableSpace.OneLight ? 1 : 0)
                .reals("colorOrigin", grid.firstX(), grid.firstY())
                .reals("colorTexelsPerUnit", 1 / grid.design().step())
                .reals("colorTilesAcross", grid.columns(), grid.rows())
                .reals("colorScale", Math.pow(numbers.scale(), -2));
        if (grid.space() instanceof TableSpace.OneLight one) {
            Direction light = one.light();
            tables.reals("colorLight", light.x(), light.y(), light.z());
        }
    }
}
