package sunbeam.app.gpu.colors;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import jrtr.GraphicsException;
import jrtr.gl.Binding;
import jrtr.gl.RenderContext;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TableLookUp;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.text.Text;

/**
 * Levels of colors in graphics memory, of which those tiles are made that pixels look into: at once by {@link #make}, or beside other
 * work once {@link #makeBy} has been called. Belongs to its context's thread.
 */
public final class LevelTiles implements AutoCloseable {
    // They lie in one texture.
    private static final long MOST_TEXTURE_BYTES = MemoryNeed.LARGEST_TEXTURE_BYTES;
    private static final double USABLE_HEAP = 0.8;
    private static final double MEGABYTE = 1e6;

    private final TileSources sources;
    private final List<TileGrid> grids;
    private final TileAtlas atlas;
    private final TileSet noted;
    private final TileSet resident;
    private final WholeLevels whole;
    private boolean hasCoarsest;
    // Where the table is validated.
    private final FootprintSample sample = new FootprintSample();
    // What was requested last, resident or not.
    private TileSet requested;
    private Optional<Scheduler> scheduler = Optional.empty();

    /** Nothing is made yet. */
    public LevelTiles(RenderContext context, LevelBakers levels) {
        this.sources = new TileSources(levels);
        this.grids = sources.grids();
        this.noted = none();
        this.resident = none();
        this.requested = none();
        this.whole = WholeLevels.of(grids);
        this.atlas = new TileAtlas(context, levels.table().numbers(), grids);
    }

    private TileSet none() {
        return TileSet.none(grids.size());
    }

    /**
     * Whether the table is there as a whole; where it is small and an earlier run has made it, takes it, so that nobody need find out what
     * pixels look into.
     */
    public boolean hasWhole() {
        if (whole.few().isEmpty()) {
            return false;
        }
        if (scheduler.isEmpty() && resident.isEmpty() && sources.missing(whole.few()) == 0) {
            make();
        }
        return whole.few().without(resident).isEmpty();
    }

    public ColorTable table() {
        return sources.table();
    }

    /** Adds the tiles of these footprints to what {@link #make} or {@link #request} are about. */
    public void note(Footprints footprints) {
        sample.add(footprints);
        noted.add(footprints.tiles(grids));
    }

    /** Goes back on what was noted. */
    public void forget() {
        sample.clear();
        noted.clear();
    }

    /**
     * Makes what was noted and is missing, while the caller waits.
     *
     * @throws GraphicsException if there is no room for it
     */
    public void make() {
        if (scheduler.isEmpty()) {
            noted.add(whole.few());
        }
        TileSet missing = noted.without(resident);
        noted.clear();
        if (missing.isEmpty()) {
            sample.clear();
            return;
        }
        if (scheduler.isPresent()) {
            throw new IllegalStateException("a picture looks into colors that were not requested for it");
        }
        expect(missing);
        sources.makeAll(missing).forEach(this::add);
        sources.validate(tabulated(), new CancellationToken());
    }

    /** What the table has where it is validated; other places are chosen from now on. */
    private FootprintSample.Tabulated tabulated() {
        FootprintSample.Tabulated tabulated = sample.tabulated(table(), atlas.lookUp(grids));
        sample.clear();
        return tabulated;
    }

    /** Returns a warning if a table's errors at samples of a picture miss a tolerance. */
    public static Optional<String> miss(ErrorStatistics errors, double tolerance) {
        return errors.keep(tolerance)
                ? Optional.empty()
                : Optional.of(Text.format(
                        "the table of colors errs by %.2g in the median and %.2g at the 95th percentile of %d samples of this picture"
                                + " (%.2g and %.2g are promised). A finer tolerance errs by less; method full has no table",
                        errors.median(),
                        errors.percentile95(),
                        errors.count(),
                        tolerance,
                        ErrorStatistics.PROMISED_PERCENTILE * tolerance));
    }

    /** The errors of the table at some of the pixels that were noted last, whose tiles exist. */
    public ErrorStatistics errors() {
        noted.clear();
        return sources.errors(tabulated(), new CancellationToken());
    }

    private void add(Scheduler.Made made) {
        int level = made.job().level();
        int[] tiles = made.job().tiles().stream().toArray();
        for (int i = 0; i < tiles.length; i++) {
            atlas.add(level, tiles[i], made.coefficients().get(i));
        }
        resident.of(level).or(made.job().tiles());
    }

    /**
     * From now on {@link #request} has tiles made by an executor; the coarsest level is begun at once, again after it
     * could not be made.
     *
     * @param executor runs one thing at a time, in the order in which they came
     * @param arrived told, by the executor, that {@link #take} has something to take
     */
    public void makeBy(Executor executor, Runnable arrived) {
        if (scheduler.isEmpty()) {
            scheduler = Optional.of(new Scheduler(grids.size(), sources, executor, arrived));
        }
        if (coarsestShare() < 1) {
            schedule(none());
        }
    }

    public boolean isScheduled() {
        return scheduler.isPresent();
    }

    private void schedule(TileSet afterwards) {
        scheduler.orElseThrow().request(new FrameRequest(whole.coarsest(), requested, afterwards));
    }

    /** Whether something moves, which leaves the processors to what is drawn. */
    public void interactive(boolean value) {
        scheduler.ifPresent(made -> made.interactive(value));
    }

    /**
     * Takes over what has been made since.
     *
     * @return whether there was anything
     */
    public boolean take() {
        boolean some = false;
        while (scheduler.isPresent()) {
            Optional<Scheduler.Made> made = scheduler.get().take();
            if (made.isEmpty()) {
                break;
            }
            add(made.get());
            some = true;
        }
        return some;
    }

    /**
     * Requests what was noted, in the place of what was requested before.
     *
     * @throws GraphicsException if there is no room for it
     */
    public void request() {
        TileSet all = noted.copy();
        noted.clear();
        TileSet missing = all.copy();
        missing.add(whole.coarsest());
        expect(missing.without(resident));
        requested = all;
        schedule(none());
    }

    /** Has made what the next picture may look into, until it is known what it does; goes back on what was noted and requested. */
    public void prefetch() {
        forget();
        requested = none();
        schedule(whole.prefetched());
    }

    /** Has the table validated where the last picture looks into it, whose tiles are there. */
    public void validate() {
        if (!sample.isEmpty()) {
            FootprintSample.Tabulated tabulated = tabulated();
            CancellationToken token = new CancellationToken();
            whenIdle(token, () -> sources.validate(tabulated, token));
        }
    }

    /** Has the executor do something once the tiles that were requested are made, and nothing moves; else the token is canceled. */
    public void whenIdle(CancellationToken token, Runnable task) {
        scheduler.orElseThrow().whenIdle(token, task);
    }

    /**
     * X, Y, Z of power at u, v, w of many places, points of the patch; by the executor, in what it does
     * {@link #whenIdle}.
     *
     * @throws java.util.concurrent.CancellationException soon after the token is canceled
     */
    public float[] exact(float[] places, CancellationToken token) {
        return sources.exact(TileSources.POINTS, places, token);
    }

    /** X, Y, Z of power at u, v, w of many places, by the finest level that is there as a whole; the coarsest must be. */
    public float[] coarse(float[] places) {
        int level = grids.size() - 1;
        TileSet missing = whole.prefetched().without(resident);
        while (level > 0
                && !whole.prefetched().of(level - 1).isEmpty()
                && missing.of(level - 1).isEmpty()) {
            level--;
        }
        double scale = table().levels().get(level).scale();
        TableLookUp table = atlas.lookUp(grids);
        float[] xyz = new float[places.length];
        for (int i = 0; i < places.length; i += 3) {
            double[] color = table.xyz(level, places[i], places[i + 1], places[i + 2]);
            for (int c = 0; c < 3; c++) {
                xyz[i + c] = (float) (scale * color[c]);
            }
        }
        return xyz;
    }

    /** Whether every look-up finds a tile, if only of the coarsest level. */
    public boolean hasCoarsest() {
        // Tiles never go again, and this is asked for each frame.
        hasCoarsest = hasCoarsest || (!whole.coarsest().isEmpty() && coarsestShare() == 1);
        return hasCoarsest;
    }

    /** Share of the coarsest level that is there; 1 where it is too large to be made as a whole. */
    public double coarsestShare() {
        return whole.coarsest().shareIn(resident);
    }

    /** Share of what was requested last that is there already, 1 for all. */
    public double requestedShare() {
        return requested.shareIn(resident);
    }

    /** Makes sure that there is room for some more tiles. */
    private void expect(TileSet missing) {
        long tiles = resident.count() + missing.count();
        NumberFormat numbers = sources.table().numbers();
        long textures = TileAtlas.bytes(tiles, numbers);
        // A copy of the textures, which lies beside the heap but may take as much, the samples, and both while they are
        // made.
        long heap = textures + LevelBaking.sampleBytes(2 * tiles) + TileAtlas.bytes(missing.count(), numbers);
        long most = Runtime.getRuntime().maxMemory();
        if (textures > MOST_TEXTURE_BYTES || heap > USABLE_HEAP * most) {
            throw new GraphicsException(Text.format(
                    "the colors that this picture sees take %.0f MB of textures and %.0f MB of Java's heap, which may take"
                            + " %.0f MB; give a coarser tolerance, a shorter coherence length, a smaller picture or"
                            + " method full (--method full); SUNBEAM_JAVA_OPTIONS=-Xmx%dm allows more",
                    textures / MEGABYTE,
                    heap / MEGABYTE,
                    most / MEGABYTE,
                    (long) (heap / USABLE_HEAP / (1 << 20)) + 1));
        }
        atlas.expect(tiles);
    }

    /** Tiles that exist, of all levels. */
    public long tiles() {
        return resident.count();
    }

    /** The textures, by the names of their samplers; valid until more is made. */
    public List<Binding> bindings() {
        return atlas.bindings();
    }

    @Override
    public void close() {
        scheduler.ifPresentOrElse(Scheduler::close, sources::close);
        atlas.close();
    }
}
