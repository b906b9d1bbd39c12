package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.FootprintErrors;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.LevelGrid;
import sunbeam.precompute.colortable.TableLevels;

/** Makes tiles of levels; one thread at a time. */
final class TileSources implements AutoCloseable {
    private final LevelSources sources;
    private final List<LevelGrid> grids = new ArrayList<>();
    private final List<LevelBaking> bakings = new ArrayList<>();
    // By level: what a source needs takes longer to get than a few colors.
    private final Map<Integer, ColorSource> opened = new TreeMap<>();
    private Progress progress = Progress.none();
    // Of what is being made: the background pauses, whoever waits for colors does not.
    private volatile Runnable between = TileSources::goOn;
    // Opened when the first tile is asked for.
    private CachedTiles cached;
    private boolean closed;
    private boolean warned;

    TileSources(LevelSources sources) {
        this.sources = sources;
        for (TableLevels.Level level : sources.levels().levels()) {
            LevelGrid grid = LevelGrid.of(level);
            grids.add(grid);
            bakings.add(new LevelBaking(grid, sources.levels().numbers()));
        }
    }

    /** The levels. */
    TableLevels levels() {
        return sources.levels();
    }

    private static void goOn() {
        // without a pause
    }

    private void evaluated(long places) {
        if (places > 0) {
            progress.step(places);
        }
        between.run();
    }

    /** Where the tiles of each level lie. */
    List<LevelGrid> grids() {
        return grids;
    }

    /**
     * Makes tiles of a level, in the order of their numbers; those that are made at the moment are waited for.
     *
     * @param pause run now and then meanwhile, by any thread, which goes on when it returns
     */
    synchronized List<byte[]> bake(int level, BitSet tiles, Runnable pause) {
        between = pause;
        try {
            return bake(level, tiles);
        } finally {
            between = TileSources::goOn;
        }
    }

    private List<byte[]> bake(int level, BitSet tiles) {
        Map<Integer, byte[]> all = new TreeMap<>(cached().read(level, tiles));
        BitSet missing = (BitSet) tiles.clone();
        all.keySet().forEach(missing::clear);
        if (!missing.isEmpty()) {
            LevelBaking baking = bakings.get(level);
            Iterator<byte[]> coefficients = baking.bake(missing, source(level)).iterator();
            Map<Integer, byte[]> made = new TreeMap<>();
            missing.stream().forEach(tile -> made.put(tile, coefficients.next()));
            cached().keep(level, made);
            all.putAll(made);
        }
        return List.copyOf(all.values());
    }

    /**
     * As {@link #bake}, of all levels, with its progress.
     *
     * @param tiles by level
     * @param made told of each level what was made
     */
    void bakeAll(List<BitSet> tiles, BiConsumer<Integer, List<byte[]>> made) {
        try (Progress shown = Progress.start("making colors", missing(tiles))) {
            progress = shown;
            for (int level = 0; level < tiles.size(); level++) {
                if (!tiles.get(level).isEmpty()) {
                    made.accept(level, bake(level, tiles.get(level), TileSources::goOn));
                }
            }
        } finally {
            progress = Progress.none();
        }
    }

    /**
     * Validates what was made at some footprints, and says once where it misses. Without effect where all was made by earlier runs.
     */
    void validate(FootprintSample.Tabulated sample) {
        if (mayMiss()) {
            errors(sample).miss(levels().tolerance()).ifPresent(this::warn);
        }
    }

    private synchronized boolean mayMiss() {
        return !opened.isEmpty() && !closed && !warned;
    }

    private synchronized void warn(String line) {
        warned = true;
        sources.warn(line);
    }

    /** The errors of colors at some footprints; meanwhile others may ask which tiles are kept. */
    FootprintErrors errors(FootprintSample.Tabulated sample) {
        return sample.errors((level, places) -> source(level).exact(places));
    }

    private synchronized ColorSource source(int level) {
        return opened.computeIfAbsent(level, number -> sources.open(number, this::evaluated));
    }

    /** Places that must be evaluated. */
    private synchronized long missing(List<BitSet> tiles) {
        long places = 0;
        for (int level = 0; level < tiles.size(); level++) {
            BitSet missing = (BitSet) tiles.get(level).clone();
            if (!missing.isEmpty()) {
                missing.andNot(cached().present(level, missing));
                places += bakings.get(level).missing(missing);
            }
        }
        return places;
    }

    /** Those of some tiles that were made by an earlier run, and take no time now. */
    synchronized BitSet cached(int level, BitSet tiles) {
        return cached().present(level, tiles);
    }

    private CachedTiles cached() {
        if (cached == null) {
            cached = sources.cached();
        }
        return cached;
    }

    @Override
    public synchronized void close() {
        closed = true;
        opened.values().forEach(ColorSource::close);
        opened.clear();
        if (cached != null) {
            cached.close();
            cached = null;
        }
    }
}
