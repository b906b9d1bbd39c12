package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import sunbeam.precompute.colortable.AtlasPages.TableLookUp;
import sunbeam.precompute.colortable.LevelBaking.CachedTiles;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.colortable.TileGrid.TableSpace;

/**
 * Table of one level for points, compared with its source at directions between its texels, and refined until it keeps its tolerance. The
 * laws of {@link TableDesign} are too coarse for some surfaces: under a coherent average the stored square roots have kinks along lines
 * between the tails of sharp orders.
 */
public record ValidatedTable(AtlasPages pages, ErrorStatistics errors) {
    // Errors fall with the fourth to sixth power of the step, more slowly at kinks.
    private static final double ORDER = 4;
    private static final double SMALLEST_FACTOR = 0.5;
    // A smaller change would not show whether refinement helps.
    private static final double LARGEST_FACTOR = 0.75;
    // Ratio of errors after and before two refinements; above, errors have another cause. One refinement is no
    // evidence, since the 95th percentile of few directions jumps.
    private static final double IMPROVEMENT = 0.8;
    // Bright directions to compare; they determine the 95th percentile to a tenth.
    static final int ENOUGH = 2000;

    // In tolerances. Source and table may err by half the tolerance each in the median. If errors have a long tail, one
    // of twenty certificates of a hundred pixels measures twice the percentile, so that the table may have 1.25 of the
    // 3 tolerances promised.
    private static final double MEDIAN_SHARE = 0.5;
    private static final double PERCENTILE_SHARE = 1.25;
    // Then one of twelve samples of fifty directions has three errors above the limit.
    private static final double PERCENTILE_98_SHARE = 3;
    // Allowed at any tolerance, since float32 causes them.
    private static final double ROUNDING = 2e-5;
    private static final double ROUNDING_PERCENTILE = 2 * ErrorBudget.FLOAT32_PERCENTILE;
    private static final String CLOSE = ", close to the limit";

    /** Receivers of lines about errors close to the tolerance or longer baking, and about errors beyond it. */
    public record Diagnostics(Consumer<String> note, Consumer<String> shortfall) {}

    /** Returns the finest level of a table of all lights, if all tiles that the points need are cached, and keep the tolerance. */
    public static Optional<ValidatedTable> cached(
            ColorTable levels,
            TablePoints points,
            CachedTiles cached,
            Function<TableDesign, ColorBaker> bakers,
            LongFunction<ColorBaker.Token> tokens) {
        TileGrid grid = TileGrid.of(levels.levels().get(0));
        BitSet tiles = points.tiles(grid);
        Map<Integer, byte[]> read = cached.present(0, tiles).equals(tiles) ? cached.read(0, tiles) : Map.of();
        if (read.size() < tiles.cardinality()) {
            return Optional.empty();
        }
        AtlasPages pages = new AtlasPages(List.of(grid), levels.numbers());
        read.forEach((tile, coefficients) -> pages.add(0, tile, coefficients));
        List<DirectionPair> samples = points.samples();
        try (ColorBaker baker = bakers.apply(grid.design());
                ColorBaker.Token token = tokens.apply(samples.size())) {
            ValidatedTable table = of(pages, baker, token, samples);
            return Optional.of(table).filter(validated -> validated.excess(levels.tolerance()) <= 1);
        }
    }

    /** Compares a table with its source at the first samples, until {@link #ENOUGH} of them are bright. */
    private static ValidatedTable of(
            AtlasPages pages, ColorBaker baker, ColorBaker.Token token, List<DirectionPair> samples) {
        TableLookUp table = pages.lookUp();
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
            float[] xyz = baker.direct().bake(uvw, token);
            for (int i = 0; i < batch.size(); i++) {
                DirectionPair pair = batch.get(i);
                Comparison one = new Comparison(table.xyz(0, pair.u(), pair.v(), pair.w()), Comparison.xyz(xyz, i), 1);
                if (one.bright()) {
                    bright.add(one);
                }
            }
        }
        return new ValidatedTable(pages, Comparison.relative(bright));
    }

    private static ValidatedTable bake(
            TileGrid grid,
            BitSet tiles,
            Function<TableDesign, ColorBaker> bakers,
            LongFunction<ColorBaker.Token> tokens,
            List<DirectionPair> samples) {
        LevelBaking baking = new LevelBaking(grid, NumberFormat.FLOAT);
        AtlasPages pages = new AtlasPages(List.of(grid), NumberFormat.FLOAT);
        try (ColorBaker baker = bakers.apply(grid.design());
                ColorBaker.Token token = tokens.apply(baking.missing(tiles) + samples.size())) {
            Iterator<byte[]> coefficients = baking.bake(tiles, baker, token).iterator();
            tiles.stream().forEach(tile -> pages.add(0, tile, coefficients.next()));
            return of(pages, baker, token, samples);
        }
    }

    /**
     * Bakes a table that, together with its source, keeps a relative error of X, Y, Z, if there is room; {@code refused} throws for a
     * necessary design that does not fit. Closes the bakers and tokens that it opens.
     */
    public static ValidatedTable make(
            double tolerance,
            TablePoints points,
            TableDesign coarsest,
            Function<TableDesign, ColorBaker> bakers,
            LongFunction<ColorBaker.Token> tokens,
            Predicate<MemoryNeed> room,
            Consumer<TableDesign> refused,
            Diagnostics diagnostics) {
        List<DirectionPair> samples = points.samples();
        TableDesign next = coarsest;
        double before = Double.POSITIVE_INFINITY;
        double beforeThat = Double.POSITIVE_INFINITY;
        while (true) {
            TileGrid grid = points.grid(next);
            ValidatedTable table = bake(grid, points.tiles(grid), bakers, tokens, samples);
            double excess = table.excess(tolerance);
            String words = table.words(tolerance);
            if (excess <= 1) {
                return table;
            }
            boolean keeps = table.errors.keep(tolerance);
            if (!(excess < IMPROVEMENT * beforeThat) || Double.isInfinite(excess)) {
                Consumer<String> receiver = keeps ? diagnostics.note : diagnostics.shortfall;
                receiver.accept("table: " + words + (keeps ? CLOSE : "") + "; smaller steps do not help");
                return table;
            }
            double factor = Math.pow(excess, -1 / ORDER);
            next = next.scaled(Math.max(SMALLEST_FACTOR, Math.min(LARGEST_FACTOR, factor)));
            if (!room.test(points.memory(next))) {
                if (!keeps) {
                    refused.accept(next);
                }
                diagnostics.note.accept("table: " + words + CLOSE + "; memory does not suffice for smaller steps");
                return table;
            }
            String again = "table: %s, beyond or close to the limit; baked again in steps of %.2g";
            diagnostics.note.accept(Text.format(again, words, next.step()));
            beforeThat = before;
            before = excess;
        }
    }

    public TileGrid grid() {
        return pages.finest();
    }

    /** Returns the largest ratio of an error to the allowed one; 0 without errors. */
    double excess(double tolerance) {
        if (errors.count() == 0) {
            return 0;
        }
        double tail = Math.max(
                errors.percentile95() / Math.max(ROUNDING_PERCENTILE, PERCENTILE_SHARE * tolerance),
                errors.percentile98() / Math.max(ROUNDING_PERCENTILE, PERCENTILE_98_SHARE * tolerance));
        return Math.max(errors.median() / Math.max(ROUNDING, MEDIAN_SHARE * tolerance), tail);
    }

    public String words(double tolerance) {
        String steps = Text.format("steps of %.2g in (u, v)", grid().design().step())
                + (grid().slices() > 1 ? ", " + grid().slices() + " slices in w" : "");
        return errors.count() == 0
                ? steps + ", not checked: all directions are dark"
                : Text.format(
                        "%s, checked at %d directions: errors relative to its source of %.2g in the median, %.2g at the 95th and %.2g at the 98th percentile"
                                + " (limits for the table and its source together: %.2g in the median, %.2g at the 95th)",
                        steps,
                        errors.count(),
                        errors.median(),
                        errors.percentile95(),
                        errors.percentile98(),
                        tolerance,
                        ErrorStatistics.PERCENTILE_95_LIMIT * tolerance);
    }

    public void putInto(ShaderTables.Builder tables) {
        pages.putInto(tables);
        TileGrid grid = grid();
        AtlasPages.define(tables, grid)
                .define("COLOR_FILTER", grid.interpolation().shaderFunction())
                .define("COLOR_ONE_LIGHT", grid.space() instanceof TableSpace.OneLight ? 1 : 0)
                .reals("colorOrigin", grid.firstX(), grid.firstY())
                .reals("colorTexelsPerUnit", 1 / grid.design().step())
                .reals("colorTilesAcross", grid.columns(), grid.rows())
                .reals("colorScale", pages.scale());
        if (grid.space() instanceof TableSpace.OneLight one) {
            Direction light = one.light();
            tables.reals("colorLight", light.x(), light.y(), light.z());
        }
    }
}
