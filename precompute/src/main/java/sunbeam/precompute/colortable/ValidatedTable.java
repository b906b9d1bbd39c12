package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

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
            LongFunction<Progress> tokens) {
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
                Progress token = tokens.apply(samples.size())) {
            return Optional.of(of(pages, baker, token, samples)).filter(table -> table.excess(levels.tolerance()) <= 1);
        }
    }

    /** Compares a table with its source at the first samples, until {@link #ENOUGH} of them are bright. */
    private static ValidatedTable of(AtlasPages pages, ColorBaker baker, Progress token, List<DirectionPair> samples) {
        AtlasPages.TableLookUp table = pages.lookUp();
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
            LongFunction<Progress> tokens,
            List<DirectionPair> samples) {
        LevelBaking baking = new LevelBaking(grid, NumberFormat.FLOAT);
        AtlasPages pages = new AtlasPages(List.of(grid), NumberFormat.FLOAT);
        try (ColorBaker baker = bakers.apply(grid.design());
                Progress token = tokens.apply(baking.missing(tiles) + samples.size())) {
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
            LongFunction<Progress> tokens,
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
            next = next.scaled(Math.max(SMALLEST_FACTOR, Math.min(LARGEST_FACTOR, Math.pow(excess, -1 / ORDER))));
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

    /** Points (u, v, w) that a map or a list of directions looks up, and the tiles that hold them: one light with all views, or pairs. */
    public record TablePoints(VisibleRange visible) {
        // 20 times the bright directions needed, since nearly all directions of a grating are dark.
        private static final int SAMPLES = 20 * ValidatedTable.ENOUGH;
        private static final long SEED = 20140607;

        public Optional<Direction> light() {
            return visible.light();
        }

        public TileGrid grid(TableDesign design) {
            return light().map(light -> TileGrid.of(design, light)).orElseGet(() -> TileGrid.of(design, visible));
        }

        public BitSet tiles(TileGrid grid) {
            if (light().isPresent()) {
                return grid.space() instanceof TableSpace.OneLight ? grid.reachable() : grid.reachable(light().get());
            }
            BitSet tiles = new BitSet();
            TileGrid.Feedback marks = new TileGrid.Feedback(grid, tiles);
            visible.pairs().forEach(pair -> marks.mark(pair.u(), pair.v(), pair.w()));
            return tiles;
        }

        /** Returns an upper estimate of the memory of a table, and of baking it. */
        public MemoryNeed memory(TableDesign design) {
            TileGrid grid = grid(design);
            double all = (double) grid.columns() * grid.rows();
            // Each point may lie on a corner of four tiles.
            double tilesOfSlice = light().isPresent()
                    ? Math.PI / 4 * all
                    : Math.min(4.0 * visible.pairs().size(), all);
            long tiles = (long) (tilesOfSlice * Math.min(grid.slices(), TableDesign.TAPS + 1));
            List<ArrayLayout> arrays = List.of(AtlasPages.texels(tiles), grid.tileList(1));
            long textures = arrays.stream().mapToLong(ArrayLayout::bytes).sum();
            return new MemoryNeed(2 * textures + 2 * LevelBaking.sampleBytes(tiles), arrays);
        }

        public VisibleRange range(TableDesign design) {
            double margin = 2 * TileGrid.STORED_SIDE * design.step();
            if (light().isPresent()) {
                TableSpace space = new TableSpace.OneLight(light().get());
                double least = -space.uvw(TableSpace.OneLight.HORIZON + margin, 0, 0)[2];
                return visible.with(0, least, visible.maximumW());
            }
            // Refinement makes slices closer, so that they stay within this range.
            double slices = (TableDesign.TAPS + 1) * design.sliceStep();
            return visible.with(
                    margin, Math.max(0, visible.minimumW() - slices), Math.min(2, visible.maximumW() + slices));
        }

        public double farthest() {
            return light().map(light -> 1 + Math.hypot(light.x(), light.y())).orElse(TableSpace.AllLights.REACH);
        }

        /** Returns directions for validation; those of one light are uniform on an orthographic map. */
        public List<DirectionPair> samples() {
            Random random = new Random(SEED);
            List<DirectionPair> samples = new ArrayList<>(visible.pairs());
            Collections.shuffle(samples, random);
            while (light().isPresent() && samples.size() < SAMPLES) {
                double x = 2 * random.nextDouble() - 1;
                double y = 2 * random.nextDouble() - 1;
                double height = 1 - x * x - y * y;
                if (height > 0) {
                    samples.add(new DirectionPair(light().get(), new Direction(x, y, Math.sqrt(height))));
                }
            }
            return samples.subList(0, Math.min(samples.size(), SAMPLES));
        }

        public String key() {
            Sha256 hash = new Sha256();
            ByteBuffer bytes = ByteBuffer.allocate(3 * Double.BYTES);
            for (DirectionPair pair : visible.pairs()) {
                bytes.clear().putDouble(pair.u()).putDouble(pair.v()).putDouble(pair.w());
                hash.add(bytes.flip());
            }
            return light().map(Direction::toString).orElseGet(hash::hex);
        }
    }
}
