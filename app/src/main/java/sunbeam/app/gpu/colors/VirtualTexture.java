package sunbeam.app.gpu.colors;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import jrtr.gl.Texture;
import sunbeam.app.work.CancellationToken;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/**
 * Virtual texture of a color table: only those tiles are resident that footprints read. They are baked while the caller waits ({@link
 * #bakeFeedback}), or in the background after {@link #bakeOn}. Belongs to its context's thread.
 */
public final class VirtualTexture implements AutoCloseable {
    private final CachedBaker baker;
    private final List<TileGrid> grids;
    private final Residency residency;
    private final TileSet feedback;
    private final CachedBaker.PrefetchSet prefetchSet;
    private final Footprints.Sample sample = new Footprints.Sample();
    private TileSet requested;
    private Optional<Scheduler> scheduler = Optional.empty();
    // Whether the cache has the whole table; checked by the scheduler's executor.
    private CompletableFuture<Boolean> isCached = CompletableFuture.completedFuture(false);

    public VirtualTexture(RenderContext context, LevelBakers levels) {
        this.baker = new CachedBaker(levels);
        this.grids = baker.grids();
        this.feedback = none();
        this.requested = none();
        this.prefetchSet = CachedBaker.PrefetchSet.of(grids);
        this.residency = new Residency(context, levels.table(), grids);
    }

    private TileSet none() {
        return TileSet.none(grids.size());
    }

    public boolean isComplete() {
        return prefetchSet.isWhole()
                && residency.missing(prefetchSet.prefetched()).isEmpty();
    }

    public ColorTable table() {
        return baker.table();
    }

    /** Adds tiles to the feedback. The table is validated at footprints {@code ofPicture}; those of metering read too coarse a level. */
    public void addFeedback(Footprints footprints, boolean ofPicture) {
        if (ofPicture) {
            sample.add(footprints);
        }
        feedback.add(footprints.tiles(grids));
    }

    public void clearFeedback() {
        sample.clear();
        feedback.clear();
    }

    /**
     * Bakes the feedback's tiles, or all of a small table, and waits. Throws {@link GraphicsException} if memory does not suffice.
     *
     * @param underMany whether there are so many lights that finding the tiles that they read takes longer than baking a larger table
     */
    public void bakeFeedback(boolean underMany) {
        if (scheduler.isPresent()) {
            throw new IllegalStateException("a picture reads tiles that were not requested for it");
        }
        if (underMany ? prefetchSet.isWhole() : prefetchSet.isSmall()) {
            feedback.add(prefetchSet.prefetched());
        }
        TileSet missing = residency.missing(feedback);
        feedback.clear();
        if (!missing.isEmpty()) {
            residency.expect(missing);
            baker.bakeAll(missing).forEach(residency::add);
        }
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
                        ErrorStatistics.PERCENTILE_95_LIMIT * tolerance));
    }

    /** Returns the errors of the table at a sample of the feedback's footprints, whose tiles must be resident. Clears the feedback. */
    public ErrorStatistics errors() {
        feedback.clear();
        return baker.errors(sample.drain(residency), Progress.NONE);
    }

    /**
     * Bakes requested tiles on an executor, which runs tasks in order, from now on, the coarsest level at once. The executor calls {@code
     * onBakedTiles} when {@link #drain} has tiles. May be called again after a failure.
     */
    public void bakeOn(Executor executor, Runnable onBakedTiles) {
        if (scheduler.isEmpty()) {
            scheduler = Optional.of(new Scheduler(baker, executor, onBakedTiles));
            isCached = CompletableFuture.supplyAsync(
                            () -> prefetchSet.isWhole() && baker.missing(prefetchSet.prefetched()) == 0, executor)
                    .exceptionally(failure -> false);
        }
        if (coarsestShare() < 1) {
            schedule(none());
        }
    }

    public boolean isScheduled() {
        return scheduler.isPresent();
    }

    private void schedule(TileSet afterwards) {
        scheduler
                .orElseThrow()
                .request(Stream.of(prefetchSet.coarsest(), requested, afterwards)
                        .map(residency::missing)
                        .toList());
    }

    /** Sets whether something moves; then only the coarsest level is baked, so that drawing has the processors. */
    public void interactive(boolean value) {
        scheduler.ifPresent(running -> running.interactive(value));
    }

    /** Makes the tiles resident that were baked since the last call; returns false if there were none. */
    public boolean drain() {
        boolean hasNew = false;
        for (Optional<Scheduler.BakedTiles> baked = poll(); baked.isPresent(); baked = poll()) {
            residency.add(baked.get());
            hasNew = true;
        }
        return hasNew;
    }

    private Optional<Scheduler.BakedTiles> poll() {
        return scheduler.flatMap(Scheduler::poll);
    }

    /** Requests the tiles of the feedback, in place of the last request. Throws {@link GraphicsException} if memory does not suffice. */
    public void request() {
        TileSet all = feedback.copy();
        feedback.add(prefetchSet.coarsest());
        TileSet missing = residency.missing(feedback);
        feedback.clear();
        residency.expect(missing);
        requested = all;
        schedule(none());
    }

    public void clearRequest() {
        request(none());
    }

    private void request(TileSet afterwards) {
        clearFeedback();
        requested = none();
        schedule(afterwards);
    }

    /**
     * Requests all tiles if all are cached or resident, which is faster than finding those that footprints read, or, if asked, if they are
     * few enough to be baked; else returns false.
     */
    public boolean requestWhole(boolean evenIfBaked) {
        boolean isWanted = evenIfBaked && prefetchSet.isWhole();
        if (!isWanted && !isCached.getNow(false) && !isComplete()) {
            return false;
        }
        feedback.add(prefetchSet.prefetched());
        request();
        return true;
    }

    /** Requests tiles that the next picture may read, in place of the last request. Clears the feedback. */
    public void prefetch() {
        request(prefetchSet.prefetched());
    }

    /** Validates the table at footprints of the last picture, whose tiles must be resident; with a scheduler once it is idle. */
    public void validate() {
        List<Footprints.Tabulated> footprints = sample.drain(residency);
        if (!footprints.isEmpty()) {
            CancellationToken token = new CancellationToken();
            Runnable validating = () -> baker.validate(footprints, token);
            scheduler.ifPresentOrElse(running -> running.whenIdle(token, validating), validating);
        }
    }

    /** Runs a task on the executor once the requested tiles are baked and nothing moves; its token is canceled when that changes. */
    public void whenIdle(CancellationToken token, Runnable task) {
        scheduler.orElseThrow().whenIdle(token, task);
    }

    /** Bakes X, Y, Z of power at these (u, v, w), without footprint, to the table's tolerance, in tasks of {@link #whenIdle}. */
    public float[] bakePoints(float[] places, CancellationToken token) {
        return baker.bakePoints(places, token);
    }

    /** Looks up X, Y, Z of power in the finest level of which all tiles are resident; those of the coarsest must be. */
    public float[] coarseColors(float[] places) {
        int level = grids.size() - 1;
        TileSet missing = residency.missing(prefetchSet.prefetched());
        while (level > 0
                && !prefetchSet.prefetched().of(level - 1).isEmpty()
                && missing.of(level - 1).isEmpty()) {
            level--;
        }
        float[] xyz = new float[places.length];
        for (int i = 0; i < places.length; i += 3) {
            double[] color = residency.mean(level, new double[] {places[i], places[i + 1], places[i + 2]});
            for (int c = 0; c < 3; c++) {
                xyz[i + c] = (float) color[c];
            }
        }
        return xyz;
    }

    /** True if every look-up finds a tile because the whole coarsest level is resident. */
    public boolean hasCoarsest() {
        return !prefetchSet.coarsest().isEmpty() && coarsestShare() == 1;
    }

    /** Resident share of the coarsest level's tiles, 0 to 1; 1 if that level is too large to be baked as a whole. */
    public double coarsestShare() {
        return residency.share(prefetchSet.coarsest());
    }

    /** Resident share of the last request's tiles, 0 to 1. */
    public double requestedShare() {
        return residency.share(requested);
    }

    /** Returns the textures by sampler name; valid until more tiles become resident. */
    public Map<String, Texture> textures() {
        return residency.textures();
    }

    @Override
    public void close() {
        scheduler.ifPresentOrElse(Scheduler::close, baker::close);
        residency.close();
    }
}
