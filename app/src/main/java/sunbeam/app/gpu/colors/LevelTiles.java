package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import jrtr.GraphicsException;
import jrtr.gl.Binding;
import jrtr.gl.RenderContext;
import sunbeam.precompute.colortable.FootprintErrors;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.LevelGrid;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.colortable.TableLookUp;
import sunbeam.precompute.colortable.TileFeedback;
import sunbeam.precompute.plan.MemoryNeed;

/**
 * Levels of colors in graphics memory, of which those tiles are made that pixels look into. Belongs to its context's thread.
 */
public final class LevelTiles implements AutoCloseable {
    // They lie in one texture.
    private static final long MOST_TEXTURE_BYTES = MemoryNeed.LARGEST_TEXTURE_BYTES;
    private static final double USABLE_HEAP = 0.8;
    private static final double MEGABYTE = 1e6;
    private static final int CHANNELS = 4;
    // Some seconds of one processor.
    private static final int MOST_RESIDENT = 6000;
    // Pixels whose tiles are found by one processor at a time: about a millisecond's work.
    private static final int NOTED_TOGETHER = 1 << 10;

    private final TileSources sources;
    private final List<LevelGrid> grids;
    private final List<BitSet> wanted = new ArrayList<>();
    private final List<BitSet> resident = new ArrayList<>();
    private final TileAtlas atlas;
    // Coarse levels as a whole, so that whatever comes into view has colors at once.
    private final List<BitSet> prefetched = new ArrayList<>();
    private boolean hasCoarsest;
    // Where the table is validated when all that was asked for is there.
    private final FootprintSample sample = new FootprintSample();
    // What was asked of the background last.
    private List<BitSet> requested = List.of();
    private Optional<TileBaker> baker = Optional.empty();

    /** Nothing is made yet. */
    public LevelTiles(RenderContext context, LevelSources levels) {
        this.sources = new TileSources(levels);
        this.grids = sources.grids();
        grids.forEach(grid -> {
            wanted.add(new BitSet());
            resident.add(new BitSet());
            prefetched.add(new BitSet());
        });
        chooseResident();
        this.atlas = new TileAtlas(context, levels.levels().numbers(), grids);
    }

    private void chooseResident() {
        int tiles = 0;
        for (int level = grids.size() - 1; level >= 0; level--) {
            BitSet all = grids.get(level).reachable();
            tiles += all.cardinality();
            if (tiles > MOST_RESIDENT) {
                return;
            }
            prefetched.set(level, all);
        }
    }

    /** The levels. */
    public TableLevels levels() {
        return sources.levels();
    }

    /**
     * Notes what pixels look into.
     *
     * @param places as shaders/footprints.frag has it: u, v, w and level
     * @param wide change of u, v, w along the major axis of what the pixel sees, and number of places
     * @param narrow change of u, v, w along the minor axis, and number of places
     * @param count of the pixels
     * @param at where in these arrays a pixel begins
     */
    public void note(float[] places, float[] wide, float[] narrow, int count, IntUnaryOperator at) {
        sample.note(places, wide, narrow, count, at);
        int parts = (count + NOTED_TOGETHER - 1) / NOTED_TOGETHER;
        IntStream.range(0, parts)
                .parallel()
                .mapToObj(part -> {
                    List<BitSet> noted = none();
                    List<TileFeedback> marks = IntStream.range(0, grids.size())
                            .mapToObj(level -> new TileFeedback(grids.get(level), noted.get(level)))
                            .toList();
                    int end = Math.min(count, (part + 1) * NOTED_TOGETHER);
                    for (int i = part * NOTED_TOGETHER; i < end; i++) {
                        note(places, wide, narrow, at.applyAsInt(i), marks);
                    }
                    return noted;
                })
                .forEachOrdered(noted -> {
                    for (int level = 0; level < noted.size(); level++) {
                        wanted.get(level).or(noted.get(level));
                    }
                });
    }

    private void note(float[] places, float[] wide, float[] narrow, int at, List<TileFeedback> marks) {
        int level = (int) places[at + 3];
        if (level < 0) {
            return;
        }
        int columns = (int) wide[at + 3];
        int rows = (int) narrow[at + 3];
        double[] uvw = new double[CHANNELS - 1];
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                for (int axis = 0; axis < uvw.length; axis++) {
                    uvw[axis] = places[at + axis]
                            + ((i + 0.5) / columns - 0.5) * wide[at + axis]
                            + ((j + 0.5) / rows - 0.5) * narrow[at + axis];
                }
                marks.get(level).mark(uvw[0], uvw[1], uvw[2]);
            }
        }
    }

    /**
     * Makes what was noted and is missing.
     *
     * @throws GraphicsException if there is no room for it
     */
    public void make() {
        for (int level = 0; level < grids.size(); level++) {
            wanted.get(level).andNot(resident.get(level));
        }
        if (count(wanted) == 0) {
            sample.clear();
            return; // without waiting for what the background makes at the moment
        }
        requireRoom();
        atlas.expect(count(resident) + count(wanted));
        sources.bakeAll(
                wanted,
                (level, coefficients) -> add(level, wanted.get(level).stream().toArray(), coefficients));
        wanted.forEach(BitSet::clear);
        sources.validate(tabulated());
    }

    /** What the table has where it is validated; other places are chosen from now on. */
    private FootprintSample.Tabulated tabulated() {
        FootprintSample.Tabulated tabulated =
                sample.tabulated(levels(), new TableLookUp(grids, levels().numbers(), atlas::tile));
        sample.clear();
        return tabulated;
    }

    /** The errors of the table at some of the pixels that were noted last, whose tiles exist. */
    public FootprintErrors errors() {
        wanted.forEach(BitSet::clear);
        return sources.errors(tabulated());
    }

    private void add(int level, int[] tiles, List<byte[]> coefficients) {
        for (int i = 0; i < tiles.length; i++) {
            if (!resident.get(level).get(tiles[i])) {
                atlas.add(level, tiles[i], coefficients.get(i));
                resident.get(level).set(tiles[i]);
            }
        }
    }

    /**
     * From now on {@link #request} has tiles made in the background; the coarsest level is begun at once.
     *
     * @param arrived told, by another thread, that {@link #takeBaked} has something to take
     */
    public void bakeInBackground(Runnable arrived) {
        if (baker.isEmpty()) {
            int last = grids.size() - 1;
            baker = Optional.of(new TileBaker(sources, arrived));
            List<BitSet> first = none();
            first.get(last).or(prefetched.get(last));
            baker.get().want(first, none());
        }
    }

    private List<BitSet> none() {
        return new ArrayList<>(grids.stream().map(grid -> new BitSet()).toList());
    }

    private static List<BitSet> copyOf(List<BitSet> tiles) {
        return tiles.stream().map(level -> (BitSet) level.clone()).toList();
    }

    /**
     * Takes over what has been made in the background.
     *
     * @return whether there was anything
     */
    public boolean takeBaked() {
        boolean some = false;
        while (baker.isPresent()) {
            Optional<TileBaker.Baked> baked = baker.get().poll();
            if (baked.isEmpty()) {
                break;
            }
            // Tiles come in the order of what is seen, coefficients in that of numbers.
            int[] tiles = Arrays.stream(baked.get().tiles()).sorted().toArray();
            add(baked.get().level(), tiles, baked.get().coefficients());
            some = true;
        }
        if (some && !sample.isEmpty() && requestedShare() == 1) {
            baker.orElseThrow().validate(tabulated());
        }
        return some;
    }

    /** Leaves the processors to what is being drawn for a while. */
    public void holdBaking() {
        baker.ifPresent(TileBaker::hold);
    }

    /** Whether every look-up finds a tile, if only of the coarsest level. */
    public boolean hasCoarsest() {
        // Tiles never go again, and this is asked for each frame.
        hasCoarsest = hasCoarsest || (!prefetched.get(grids.size() - 1).isEmpty() && coarsestShare() == 1);
        return hasCoarsest;
    }

    /** Share of the coarsest level that is there; 1 where it is too large to be made as a whole. */
    public double coarsestShare() {
        List<BitSet> coarsest = none();
        coarsest.set(grids.size() - 1, prefetched.get(grids.size() - 1));
        return share(coarsest);
    }

    /** Share of what was requested last that is there already, 1 for all. */
    public double requestedShare() {
        return share(requested);
    }

    private double share(List<BitSet> tiles) {
        long all = count(tiles);
        long there = 0;
        for (int level = 0; level < tiles.size(); level++) {
            BitSet both = (BitSet) tiles.get(level).clone();
            both.and(resident.get(level));
            there += both.cardinality();
        }
        return all == 0 ? 1 : (double) there / all;
    }

    /**
     * Asks the background for what was noted, in the place of what it was asked for before.
     *
     * @throws GraphicsException if there is no room for it
     */
    public void request() {
        requested = List.of();
        requestToo();
        sample.clear();
    }

    /** As {@link #request}, beside what it was asked for before. */
    public void requestToo() {
        for (int level = 0; level < requested.size(); level++) {
            wanted.get(level).or(requested.get(level));
        }
        wanted.get(grids.size() - 1).or(prefetched.get(grids.size() - 1));
        List<BitSet> asked = copyOf(wanted);
        for (int level = 0; level < grids.size(); level++) {
            wanted.get(level).andNot(resident.get(level));
        }
        List<BitSet> missing = copyOf(wanted);
        requireRoom();
        atlas.expect(count(resident) + count(wanted));
        requested = asked;
        wanted.forEach(BitSet::clear);
        baker.orElseThrow().want(missing, copyOf(prefetched));
    }

    /** Goes back on what was noted. */
    public void forget() {
        sample.clear();
        wanted.forEach(BitSet::clear);
    }

    private static long count(List<BitSet> tiles) {
        return tiles.stream().mapToLong(BitSet::cardinality).sum();
    }

    private void requireRoom() {
        long tiles = count(resident) + count(wanted);
        NumberFormat numbers = sources.levels().numbers();
        long textures = TileAtlas.bytes(tiles, numbers);
        // A copy of the textures, which lies beside the heap but may take as much, the samples, and both while they are
        // made.
        long heap = textures + LevelBaking.sampleBytes(2 * tiles) + TileAtlas.bytes(count(wanted), numbers);
        long most = Runtime.getRuntime().maxMemory();
        if (textures > MOST_TEXTURE_BYTES || heap > USABLE_HEAP * most) {
            throw new GraphicsException(String.format(
                    Locale.ROOT,
                    "the colors that this picture sees take %.0f MB of textures and %.0f MB of Java's heap, which may take"
                            + " %.0f MB; give a coarser tolerance, a shorter coherence length, a smaller picture or"
                            + " method full (--method full); SUNBEAM_JAVA_OPTIONS=-Xmx%dm allows more",
                    textures / MEGABYTE,
                    heap / MEGABYTE,
                    most / MEGABYTE,
                    (long) (heap / USABLE_HEAP / (1 << 20)) + 1));
        }
    }

    /** Tiles that exist, of all levels. */
    public long tiles() {
        return count(resident);
    }

    /** The textures, by the names of their samplers; valid until more is made. */
    public List<Binding> bindings() {
        return atlas.bindings();
    }

    @Override
    public void close() {
        baker.ifPresentOrElse(TileBaker::close, sources::close);
        atlas.close();
    }
}
