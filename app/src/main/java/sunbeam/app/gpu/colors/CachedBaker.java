package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.app.work.CancellationToken;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.work.Progress;

/** Bakes tiles of a color table or reads cached ones. Not thread-safe; a level's baker may need the thread that opened it. */
final class CachedBaker implements Scheduler.TileBaker {
    // About a second on two processors. Smaller jobs show progress sooner but evaluate more rays twice.
    private static final int RADIAL_BATCH = 4800;
    // A shader's job is one draw, which cannot be canceled, so that it must be short.
    private static final int SHADER_BATCH = 64;

    // Samples between checks of the token: some milliseconds on one processor.
    private static final int SAMPLE_BATCH = 96;

    // Key of the baker of points of the patch, over which no level averages.
    private static final int POINTS = -1;

    private final LevelBakers bakers;
    private final List<TileGrid> grids = new ArrayList<>();
    private final List<LevelBaking> bakings = new ArrayList<>();
    // Keys are levels or POINTS. Opening a baker takes longer than baking a few samples.
    private final Map<Integer, ColorBaker> openBakers = new TreeMap<>();
    private CachedTiles cached;
    private boolean hasBaked;
    private boolean warned;

    CachedBaker(LevelBakers bakers) {
        this.bakers = bakers;
        for (ColorTable.Level level : bakers.table().levels()) {
            TileGrid grid = TileGrid.of(level);
            grids.add(grid);
            bakings.add(new LevelBaking(grid, bakers.table().numbers()));
        }
    }

    ColorTable table() {
        return bakers.table();
    }

    List<TileGrid> grids() {
        return grids;
    }

    /** Bakes cached tiles first, then the coarsest level; within a level, tiles at similar angles of (u, v), which share rays. */
    @Override
    public Scheduler.BakedTiles bake(TileSet missing, CancellationToken token) {
        for (int level = missing.levels() - 1; level >= 0; level--) {
            BitSet present = cached().present(level, missing.of(level));
            if (!present.isEmpty()) {
                return bake(level, setOf(present.stream().limit(RADIAL_BATCH)), token);
            }
        }
        int level = missing.levels() - 1;
        while (missing.of(level).isEmpty()) {
            level--;
        }
        // A table of one level is that of a coherent average, which shaders evaluate.
        int batch = grids.size() > 1 ? RADIAL_BATCH : SHADER_BATCH;
        token.step(0);
        return bake(level, setOf(grids.get(level).byAngle(missing.of(level)).limit(batch)), token);
    }

    private static BitSet setOf(IntStream tiles) {
        return tiles.collect(BitSet::new, BitSet::set, BitSet::or);
    }

    private Scheduler.BakedTiles bake(int level, BitSet tiles, Progress token) {
        Map<Integer, byte[]> all = new TreeMap<>(cached().read(level, tiles));
        BitSet missing = (BitSet) tiles.clone();
        all.keySet().forEach(missing::clear);
        if (!missing.isEmpty()) {
            hasBaked = true;
            Iterator<byte[]> coefficients =
                    bakings.get(level).bake(missing, baker(level), token).iterator();
            Map<Integer, byte[]> made = new TreeMap<>();
            missing.stream().forEach(tile -> made.put(tile, coefficients.next()));
            cached().keep(level, made);
            all.putAll(made);
        }
        return new Scheduler.BakedTiles(level, tiles, List.copyOf(all.values()));
    }

    List<Scheduler.BakedTiles> bakeAll(TileSet tiles) {
        List<Scheduler.BakedTiles> all = new ArrayList<>();
        try (Progress progress = bakers.sources().progress(missing(tiles))) {
            for (int level = 0; level < tiles.levels(); level++) {
                if (!tiles.of(level).isEmpty()) {
                    all.add(bake(level, tiles.of(level), progress));
                }
            }
        }
        return all;
    }

    /** Returns the number of samples to evaluate for tiles that the cache lacks. */
    long missing(TileSet tiles) {
        long places = 0;
        for (int level = 0; level < tiles.levels(); level++) {
            BitSet missing = (BitSet) tiles.of(level).clone();
            if (!missing.isEmpty()) {
                missing.andNot(cached().present(level, missing));
                places += bakings.get(level).missing(missing);
            }
        }
        return places;
    }

    /** Validates newly baked tiles at some footprints; beyond the tolerance warns once and discards the cached tiles. */
    void validate(List<Footprints.Tabulated> sample, Progress token) {
        if (hasBaked && !warned) {
            VirtualTexture.miss(errors(sample, token), table().tolerance()).ifPresent(line -> {
                warned = true;
                cached().discard();
                bakers.sources().diagnostics().shortfall().accept(line);
            });
        }
    }

    ErrorStatistics errors(List<Footprints.Tabulated> sample, Progress token) {
        List<Comparison> compared = new ArrayList<>();
        sample.stream()
                .collect(Collectors.groupingBy(Footprints.Tabulated::level))
                .forEach((level, footprints) -> {
                    double scale = table().levels().get(level).scale();
                    float[] exact = evaluate(level, places(footprints), token);
                    int first = 0;
                    for (Footprints.Tabulated footprint : footprints) {
                        compared.add(footprint.compare(exact, first, scale));
                        first += 3 * footprint.taps().length;
                    }
                });
        return Comparison.relative(compared);
    }

    private static float[] places(List<Footprints.Tabulated> footprints) {
        double[] places = footprints.stream()
                .flatMap(footprint -> Arrays.stream(footprint.taps()))
                .flatMapToDouble(Arrays::stream)
                .toArray();
        return Floats.of(places.length, i -> places[i]);
    }

    /** Bakes colors of points of the patch at once: neighbors share work. */
    float[] bakePoints(float[] places, Progress token) {
        return baker(POINTS).bake(places, token);
    }

    /** Evaluates colors of a level, not yet multiplied by the level's scale. */
    private float[] evaluate(int level, float[] places, Progress token) {
        ColorBaker direct = baker(level).direct();
        float[] xyz = new float[places.length];
        for (int from = 0; from < places.length; from += 3 * SAMPLE_BATCH) {
            token.step(0);
            int to = Math.min(places.length, from + 3 * SAMPLE_BATCH);
            float[] part = direct.bake(Arrays.copyOfRange(places, from, to), token);
            System.arraycopy(part, 0, xyz, from, part.length);
        }
        return xyz;
    }

    private ColorBaker baker(int level) {
        return openBakers.computeIfAbsent(level, number -> number == POINTS ? bakers.points() : bakers.level(number));
    }

    private CachedTiles cached() {
        if (cached == null) {
            cached = bakers.cached();
        }
        return cached;
    }

    @Override
    public void close() {
        openBakers.values().forEach(ColorBaker::close);
        openBakers.clear();
        if (cached != null) {
            cached.close();
            cached = null;
        }
    }

    /** Tiles baked without feedback, for parts that come into view: all of the coarsest level, if not too many, and of coarse levels. */
    record PrefetchSet(TileSet coarsest, TileSet prefetched, boolean isWhole) {
        // Baking these takes some seconds on one processor.
        private static final int MOST_PREFETCHED = 6000;
        // Baking a smaller table as a whole is faster than finding the tiles that footprints read.
        private static final int SMALL_TABLE = 2000;

        static PrefetchSet of(List<TileGrid> grids) {
            TileSet coarsest = TileSet.none(grids.size());
            TileSet prefetched = TileSet.none(grids.size());
            for (int level = grids.size() - 1; level >= 0; level--) {
                BitSet all = grids.get(level).reachable();
                if (prefetched.count() + all.cardinality() > MOST_PREFETCHED) {
                    return new PrefetchSet(coarsest, prefetched, false);
                }
                prefetched.of(level).or(all);
                if (level == grids.size() - 1) {
                    coarsest.of(level).or(all);
                }
            }
            return new PrefetchSet(coarsest, prefetched, true);
        }

        boolean isSmall() {
            return isWhole && prefetched.count() <= SMALL_TABLE;
        }
    }
}
