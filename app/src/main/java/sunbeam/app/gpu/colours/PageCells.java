package sunbeam.app.gpu.colours;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import jrtr.Binding;
import jrtr.Filter;
import jrtr.FloatFormat;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import sunbeam.precompute.colourtable.LevelGrid;
import sunbeam.precompute.colourtable.TableLevels;
import sunbeam.precompute.plan.MemoryNeed;

/**
 * The pages of levels on the graphics card: cells beside each other in layers of texels, in the order in which they came, and
 * for each page that there could be the number of its cell (shaders/method/table_levels.glsl).
 */
final class PageCells implements AutoCloseable {
    private static final int CELL = LevelGrid.STORED_SIDE;
    // A power of two: places in it are exact (table_levels.glsl).
    static final int LAYER_SIDE = 512;

    /** Cells along a layer's side. */
    static final int ACROSS = LAYER_SIDE / CELL;

    private static final int CHANNELS = 4;
    private static final int PER_LAYER = ACROSS * ACROSS;
    private static final int LAYER_FLOATS = CHANNELS * LAYER_SIDE * LAYER_SIDE;
    // Beyond, drivers may have no texture; who needs more layers is told so before.
    private static final int MOST_LAYERS = (int) (MemoryNeed.LARGEST_TEXTURE_BYTES / LAYER_FLOATS / Float.BYTES);

    private final RenderContext context;
    private final List<LevelGrid> grids;
    private final int slices;
    private final int columns;
    private final List<float[]> layers = new ArrayList<>();
    private final BitSet changed = new BitSet();
    // Of each slice of each level: cell of each page plus one, then that of the same page of the next slice.
    private final float[][] numbers;
    private FloatTexture texels;
    private FloatTexture pages;
    private int cells;
    private long expectedPages;

    PageCells(RenderContext context, TableLevels levels, List<LevelGrid> grids) {
        this.context = context;
        this.grids = grids;
        this.slices = levels.slices();
        this.columns = grids.get(0).columns();
        this.numbers = new float[grids.size() * slices][2 * columns * columns];
        // A mesh that turns its back to the light looks into nothing, but its shader reads textures.
        addLayer();
    }

    /** Bytes of the layers that some pages fill, on the card and once more in Java's heap. */
    static long bytes(long pages) {
        return (pages + PER_LAYER - 1) / PER_LAYER * LAYER_FLOATS * Float.BYTES;
    }

    /** Tells how many pages there will be, so that the card makes room for them once. */
    void expect(long pages) {
        expectedPages = pages;
    }

    /** Adds a page; it is on the card from the next {@link #bindings()} on. */
    void add(int level, int page, float[] coefficients) {
        int layer = cells / PER_LAYER;
        if (layer == layers.size()) {
            addLayer();
        }
        int inLayer = cells % PER_LAYER;
        int left = inLayer % ACROSS * CELL;
        int top = inLayer / ACROSS * CELL;
        for (int row = 0; row < CELL; row++) {
            System.arraycopy(
                    coefficients,
                    CHANNELS * row * CELL,
                    layers.get(layer),
                    CHANNELS * ((top + row) * LAYER_SIDE + left),
                    CHANNELS * CELL);
        }
        changed.set(layer);
        cells++;
        int across = grids.get(level).columns();
        int perSlice = across * across;
        int inSlice = page % perSlice;
        int place = 2 * (inSlice / across * columns + inSlice % across);
        int slice = page / perSlice;
        numbers[level * slices + slice][place] = cells;
        if (slice > 0) {
            numbers[level * slices + slice - 1][place + 1] = cells;
        }
    }

    private void addLayer() {
        changed.set(layers.size());
        layers.add(new float[LAYER_FLOATS]);
    }

    /** The textures, by the names of their samplers; valid until a page is added. */
    List<Binding> bindings() {
        if (!changed.isEmpty()) {
            upload();
        }
        return List.of(new Binding("colourTexels", texels), new Binding("colourPages", pages));
    }

    private void closeTexels() {
        if (texels != null) {
            texels.close();
            texels = null;
        }
    }

    /** Layers that a new texture has. */
    private int room() {
        int needed = Math.max(layers.size(), Math.toIntExact((expectedPages + PER_LAYER - 1) / PER_LAYER));
        if (texels == null || needed > layers.size()) {
            return needed;
        }
        // Whoever has come back for more will again: all is uploaded anew as seldom as the number doubles.
        return Math.max(needed, Math.min(2 * texels.spec().layers(), MOST_LAYERS));
    }

    private void upload() {
        if (texels == null || texels.spec().layers() < layers.size()) {
            int room = room();
            closeTexels();
            FloatTextureSpec spec = FloatTextureSpec.array(LAYER_SIDE, LAYER_SIDE, room, FloatFormat.RGBA32F);
            texels = context.createFloatTexture("colours", spec.with(Filter.LINEAR));
            changed.set(0, layers.size());
            FloatBuffer empty = FloatBuffer.wrap(new float[LAYER_FLOATS]);
            for (int layer = layers.size(); layer < room; layer++) {
                texels.uploadLayer(layer, empty.rewind());
            }
        }
        changed.stream().forEach(layer -> texels.uploadLayer(layer, FloatBuffer.wrap(layers.get(layer))));
        changed.clear();
        if (pages == null) {
            pages = context.createFloatTexture(
                    "colour pages", FloatTextureSpec.array(columns, columns, numbers.length, FloatFormat.RG32F));
        }
        for (int layer = 0; layer < numbers.length; layer++) {
            pages.uploadLayer(layer, FloatBuffer.wrap(numbers[layer]));
        }
    }

    @Override
    public void close() {
        closeTexels();
        if (pages != null) {
            pages.close();
            pages = null;
        }
    }
}
