package sunbeam.app.gpu.colours;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import jrtr.Binding;
import jrtr.GraphicsException;
import jrtr.RenderContext;
import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.colourtable.LevelBaking;
import sunbeam.precompute.colourtable.LevelGrid;
import sunbeam.precompute.colourtable.TableLevels;

/**
 * Levels of colours in graphics memory, of which those pages are made that pixels look into. Belongs to its context's thread.
 */
public final class LevelPages implements AutoCloseable {
    // What small graphics cards have, as of all tables (sunbeam.precompute.plan.MemoryNeed).
    private static final long MOST_TEXTURE_BYTES = 3L << 30;
    private static final double USABLE_HEAP = 0.8;
    private static final double MEGABYTE = 1e6;
    private static final int CHANNELS = 4;

    private final LevelSources sources;
    private final List<LevelGrid> grids = new ArrayList<>();
    private final List<LevelBaking> bakings = new ArrayList<>();
    private final List<BitSet> wanted = new ArrayList<>();
    private final List<BitSet> made = new ArrayList<>();
    // By level: what a source needs takes longer to get than a few colours.
    private final Map<Integer, ColourSource> opened = new TreeMap<>();
    private final PageCells cells;

    /** Nothing is made yet. */
    public LevelPages(RenderContext context, LevelSources sources) {
        this.sources = sources;
        for (TableLevels.Level level : sources.levels().levels()) {
            LevelGrid grid = new LevelGrid(level.design());
            grids.add(grid);
            bakings.add(new LevelBaking(grid));
            wanted.add(new BitSet());
            made.add(new BitSet());
        }
        this.cells = new PageCells(context, sources.levels(), grids);
    }

    /** The levels. */
    public TableLevels levels() {
        return sources.levels();
    }

    /**
     * Notes what a pixel looks into.
     *
     * @param places as shaders/looks.frag has it: u, v, w and level
     * @param wide change of u, v, w along the wide side of what the pixel sees, and number of places
     * @param narrow change of u, v, w along the narrow side, and number of places
     * @param at where in these arrays the pixel begins
     */
    public void note(float[] places, float[] wide, float[] narrow, int at) {
        int level = (int) places[at + 3];
        if (level < 0) {
            return;
        }
        int columns = (int) wide[at + 3];
        int rows = (int) narrow[at + 3];
        LevelGrid grid = grids.get(level);
        BitSet pages = wanted.get(level);
        double[] uvw = new double[CHANNELS - 1];
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                for (int axis = 0; axis < uvw.length; axis++) {
                    uvw[axis] = places[at + axis]
                            + ((i + 0.5) / columns - 0.5) * wide[at + axis]
                            + ((j + 0.5) / rows - 0.5) * narrow[at + axis];
                }
                grid.visit(uvw[0], uvw[1], uvw[2], pages::set);
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
            wanted.get(level).andNot(made.get(level));
        }
        requireRoom();
        for (int level = 0; level < grids.size(); level++) {
            if (!wanted.get(level).isEmpty()) {
                make(level, wanted.get(level));
            }
            wanted.get(level).clear();
        }
    }

    private void make(int level, BitSet pages) {
        LevelBaking baking = bakings.get(level);
        ColourSource source = opened.computeIfAbsent(level, number -> sources.open(number, baking.missing(pages)));
        List<float[]> baked = baking.bake(pages, source);
        int[] numbers = pages.stream().toArray();
        for (int i = 0; i < numbers.length; i++) {
            cells.add(level, numbers[i], baked.get(i));
        }
        made.get(level).or(pages);
    }

    private static long count(List<BitSet> pages) {
        return pages.stream().mapToLong(BitSet::cardinality).sum();
    }

    private void requireRoom() {
        long pages = count(made) + count(wanted);
        long textures = PageCells.bytes(pages);
        // A copy of the textures, the samples, and both while they are made.
        long heap = textures + LevelBaking.sampleBytes(2 * pages) + PageCells.bytes(count(wanted));
        long most = Runtime.getRuntime().maxMemory();
        if (textures > MOST_TEXTURE_BYTES || heap > USABLE_HEAP * most) {
            throw new GraphicsException(String.format(
                    Locale.ROOT,
                    "the colours that this picture sees take %.0f MB of textures and %.0f MB of Java's heap, which may take"
                            + " %.0f MB; give a coarser tolerance, a shorter coherence length, a smaller picture or the"
                            + " method full (SUNBEAM_JAVA_OPTIONS=-Xmx%dm allows more)",
                    textures / MEGABYTE,
                    heap / MEGABYTE,
                    most / MEGABYTE,
                    (long) (heap / USABLE_HEAP / (1 << 20)) + 1));
        }
    }

    /** Pages that exist, of all levels. */
    public long pages() {
        return count(made);
    }

    /** Cells along the side of a layer of texels, as the shader asks. */
    public int cellsAcross() {
        return PageCells.ACROSS;
    }

    /** The textures, by the names of their samplers; valid until more is made. */
    public List<Binding> bindings() {
        return cells.bindings();
    }

    @Override
    public void close() {
        opened.values().forEach(ColourSource::close);
        opened.clear();
        cells.close();
    }
}
