package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.TableArray;

/**
 * Atlas pages and page table, as in shaders/include/color_table.glsl. Pages lie side by side in layers of texels, in the order in which
 * tiles are added. The page table has two numbers for each tile: its page number plus one (0 without a page), and that of the tile at its
 * column and row in the next slice. Not thread-safe.
 */
public final class AtlasPages {
    /** Texels along a layer's side: a power of two, so that texture coordinates are exact. */
    public static final int LAYER_SIDE = 512;

    private static final int PAGE_SIDE = TileGrid.STORED_SIDE;
    private static final int PAGES_ACROSS = LAYER_SIDE / PAGE_SIDE;
    private static final int CHANNELS = 4;
    public static final int PER_LAYER = PAGES_ACROSS * PAGES_ACROSS;
    public static final int LAYER_NUMBERS = CHANNELS * LAYER_SIDE * LAYER_SIDE;

    private final List<TileGrid> grids;
    private final NumberFormat format;
    private final TileGrid finest;
    // Direct buffers, which the garbage collector does not move.
    private final List<ByteBuffer> layers = new ArrayList<>();
    private final float[][] pageTable;
    private int pages;

    public AtlasPages(List<TileGrid> grids, NumberFormat format) {
        this.grids = List.copyOf(grids);
        this.format = format;
        this.finest = grids.get(0);
        this.pageTable = new float[grids.size() * finest.slices()][2 * finest.perSlice()];
        // The shader samples a page even if no tile is needed.
        layers.add(newLayer());
    }

    public static int layers(long tiles) {
        return (int) Math.max(1, (tiles + PER_LAYER - 1) / PER_LAYER);
    }

    static ArrayLayout texels(long tiles) {
        return ArrayLayout.layered("colorTexels", LAYER_SIDE, LAYER_SIDE, layers(tiles), CHANNELS)
                .linear();
    }

    public static ShaderTables.Builder define(ShaderTables.Builder tables, TileGrid finest) {
        return tables.define("COLOR_SLICES", finest.slices())
                .define("COLOR_TILE_SIDE", (float) TileGrid.SIDE)
                .define("COLOR_LAYER_SIDE", (float) LAYER_SIDE)
                .reals("perColorTiles", 1.0 / finest.columns(), 1.0 / finest.rows())
                .reals("colorSlicesPerUnit", 1 / finest.design().sliceStep());
    }

    public ByteBuffer newLayer() {
        return ByteBuffer.allocateDirect(LAYER_NUMBERS * format.bytes()).order(ByteOrder.nativeOrder());
    }

    /** Adds a tile's coefficients, as {@link LevelBaking#bake} returns them, and returns the index of their layer. */
    public int add(int level, int tile, byte[] coefficients) {
        int layer = pages / PER_LAYER;
        if (layer == layers.size()) {
            layers.add(newLayer());
        }
        for (int row = 0; row < PAGE_SIDE; row++) {
            layers.get(layer).put(begin(pages, row), coefficients, row * rowBytes(), rowBytes());
        }
        pages++;
        TileGrid grid = grids.get(level);
        int slice = level * finest.slices() + tile / grid.perSlice();
        pageTable[slice][indexInTable(grid, tile)] = pages;
        if (tile >= grid.perSlice()) {
            pageTable[slice - 1][indexInTable(grid, tile) + 1] = pages;
        }
        return layer;
    }

    private int rowBytes() {
        return CHANNELS * format.bytes() * PAGE_SIDE;
    }

    private int begin(int page, int row) {
        int inLayer = page % PER_LAYER;
        int top = inLayer / PAGES_ACROSS * PAGE_SIDE;
        return CHANNELS * format.bytes() * ((top + row) * LAYER_SIDE + inLayer % PAGES_ACROSS * PAGE_SIDE);
    }

    private int indexInTable(TileGrid grid, int tile) {
        int inSlice = tile % grid.perSlice();
        return 2 * (inSlice / grid.columns() * finest.columns() + inSlice % grid.columns());
    }

    private float coefficient(int level, int tile, int index) {
        TileGrid grid = grids.get(level);
        int page = (int) pageTable[level * finest.slices() + tile / grid.perSlice()][indexInTable(grid, tile)] - 1;
        int row = CHANNELS * PAGE_SIDE;
        int number = begin(page, index / row) / format.bytes() + index % row;
        return format.decoded(layers.get(page / PER_LAYER), number);
    }

    public TableLookUp lookUp() {
        return new TableLookUp(grids, format, this::coefficient);
    }

    public List<ByteBuffer> layers() {
        return layers;
    }

    public float[][] pageTable() {
        return pageTable;
    }

    TileGrid finest() {
        return finest;
    }

    /** Returns the factor of the coefficients' squares that gives power. */
    double scale() {
        return Math.pow(format.scale(), -2);
    }

    void putInto(ShaderTables.Builder tables) {
        tables.array(new TableArray(texels(pages), layer -> format.floats(layers.get(layer))))
                .array(new TableArray(finest.tileList(grids.size()), layer -> FloatBuffer.wrap(pageTable[layer])));
    }
}
