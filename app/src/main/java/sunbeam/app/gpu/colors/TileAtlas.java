package sunbeam.app.gpu.colors;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import jrtr.Filter;
import jrtr.FloatFormat;
import jrtr.FloatTextureSpec;
import jrtr.gl.Binding;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import sunbeam.precompute.colortable.LevelGrid;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.plan.MemoryNeed;

/**
 * The tiles of levels on the graphics card: cells beside each other in layers of texels, in the order in which they came, and
 * for each tile that there could be the number of its cell (shaders/method/table_levels.glsl).
 */
final class TileAtlas implements AutoCloseable {
    private static final int CELL = LevelGrid.STORED_SIDE;
    // A power of two: places in it are exact (table_levels.glsl).
    static final int LAYER_SIDE = 512;

    /** Cells along a layer's side. */
    static final int ACROSS = LAYER_SIDE / CELL;

    private static final int CHANNELS = 4;
    private static final int PER_LAYER = ACROSS * ACROSS;
    private static final int LAYER_NUMBERS = CHANNELS * LAYER_SIDE * LAYER_SIDE;

    private final RenderContext context;
    private final List<LevelGrid> grids;
    private final int slices;
    private final int columns;
    private final NumberFormat format;
    // Beside Java's heap, which would move them about.
    private final List<ByteBuffer> layers = new ArrayList<>();
    private final BitSet changed = new BitSet();
    // Of each slice of each level: cell of each tile plus one, then that of the same tile of the next slice.
    private final float[][] numbers;
    private FloatTexture texels;
    private FloatTexture tiles;
    private int cells;
    private long expectedTiles;

    TileAtlas(RenderContext context, TableLevels levels, List<LevelGrid> grids) {
        this.context = context;
        this.grids = grids;
        this.slices = levels.slices();
        this.columns = grids.get(0).columns();
        this.format = levels.numbers();
        this.numbers = new float[grids.size() * slices][2 * columns * columns];
        // A mesh that turns its back to the light looks into nothing, but its shader reads textures.
        addLayer();
    }

    /** Bytes of the layers that some tiles fill, on the card and once more beside it. */
    static long bytes(long tiles, NumberFormat format) {
        return (tiles + PER_LAYER - 1) / PER_LAYER * LAYER_NUMBERS * format.bytes();
    }

    /** Tells how many tiles there will be, so that the card makes room for them once. */
    void expect(long tiles) {
        expectedTiles = tiles;
    }

    /** Adds a tile; it is on the card from the next {@link #bindings()} on. */
    void add(int level, int tile, byte[] coefficients) {
        int layer = cells / PER_LAYER;
        if (layer == layers.size()) {
            addLayer();
        }
        int inLayer = cells % PER_LAYER;
        int left = inLayer % ACROSS * CELL;
        int top = inLayer / ACROSS * CELL;
        int texelBytes = CHANNELS * format.bytes();
        for (int row = 0; row < CELL; row++) {
            layers.get(layer)
                    .put(
                            texelBytes * ((top + row) * LAYER_SIDE + left),
                            coefficients,
                            texelBytes * row * CELL,
                            texelBytes * CELL);
        }
        changed.set(layer);
        cells++;
        int across = grids.get(level).columns();
        int perSlice = across * across;
        int inSlice = tile % perSlice;
        int place = 2 * (inSlice / across * columns + inSlice % across);
        int slice = tile / perSlice;
        numbers[level * slices + slice][place] = cells;
        if (slice > 0) {
            numbers[level * slices + slice - 1][place + 1] = cells;
        }
    }

    /** The coefficients of a tile that was added. */
    byte[] tile(int level, int tile) {
        int across = grids.get(level).columns();
        int perSlice = across * across;
        int inSlice = tile % perSlice;
        int cell = (int) numbers[level * slices + tile / perSlice][2 * (inSlice / across * columns + inSlice % across)]
                - 1;
        int inLayer = cell % PER_LAYER;
        int left = inLayer % ACROSS * CELL;
        int top = inLayer / ACROSS * CELL;
        int texelBytes = CHANNELS * format.bytes();
        byte[] coefficients = new byte[texelBytes * CELL * CELL];
        for (int row = 0; row < CELL; row++) {
            layers.get(cell / PER_LAYER)
                    .get(
                            texelBytes * ((top + row) * LAYER_SIDE + left),
                            coefficients,
                            texelBytes * row * CELL,
                            texelBytes * CELL);
        }
        return coefficients;
    }

    private void addLayer() {
        changed.set(layers.size());
        layers.add(newLayer());
    }

    private ByteBuffer newLayer() {
        return ByteBuffer.allocateDirect(LAYER_NUMBERS * format.bytes()).order(ByteOrder.nativeOrder());
    }

    /** The textures, by the names of their samplers; valid until a tile is added. */
    List<Binding> bindings() {
        if (!changed.isEmpty()) {
            upload();
        }
        return List.of(new Binding("colorTexels", texels), new Binding("colorTiles", tiles));
    }

    private void closeTexels() {
        if (texels != null) {
            texels.close();
            texels = null;
        }
    }

    /** Layers that a new texture has. */
    private int room() {
        int needed = Math.max(layers.size(), Math.toIntExact((expectedTiles + PER_LAYER - 1) / PER_LAYER));
        if (texels == null || needed > layers.size()) {
            return needed;
        }
        // Whoever has come back for more will again: all is uploaded anew as seldom as the number doubles.
        return Math.max(needed, Math.min(2 * texels.spec().layers(), mostLayers()));
    }

    /** Beyond, drivers may have no texture; who needs more layers is told so before. */
    private int mostLayers() {
        return (int) (MemoryNeed.LARGEST_TEXTURE_BYTES / LAYER_NUMBERS / format.bytes());
    }

    private void upload() {
        if (texels == null || texels.spec().layers() < layers.size()) {
            int room = room();
            closeTexels();
            FloatTextureSpec spec = FloatTextureSpec.array(LAYER_SIDE, LAYER_SIDE, room, texelFormat());
            texels = context.createFloatTexture("colors", spec.with(Filter.LINEAR));
            changed.set(0, layers.size());
            ByteBuffer empty = newLayer();
            for (int layer = layers.size(); layer < room; layer++) {
                upload(layer, empty);
            }
        }
        changed.stream().forEach(layer -> upload(layer, layers.get(layer)));
        changed.clear();
        if (tiles == null) {
            tiles = context.createFloatTexture(
                    "color tiles", FloatTextureSpec.array(columns, columns, numbers.length, FloatFormat.RG32F));
        }
        for (int layer = 0; layer < numbers.length; layer++) {
            tiles.uploadLayer(layer, FloatBuffer.wrap(numbers[layer]));
        }
    }

    private FloatFormat texelFormat() {
        return format == NumberFormat.HALF ? FloatFormat.RGBA16F : FloatFormat.RGBA32F;
    }

    private void upload(int layer, ByteBuffer numbersOfTexels) {
        if (format == NumberFormat.HALF) {
            texels.uploadLayer(layer, numbersOfTexels.asShortBuffer());
        } else {
            texels.uploadLayer(layer, numbersOfTexels.asFloatBuffer());
        }
    }

    @Override
    public void close() {
        closeTexels();
        if (tiles != null) {
            tiles.close();
            tiles = null;
        }
    }
}
