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
 * Tiles as shaders/include/color_table.glsl reads them: cells beside each other in layers of texels, in the order in which they came, and for
 * each tile that there could be the number of its cell plus one, and that of the same tile of the next slice. Belongs to one thread.
 */
public final class TileCells {
    /** Texels along a layer's side: a power of two, so that places in it are exact. */
    public static final int LAYER_SIDE = 512;

    private static final int CELL = TileGrid.STORED_SIDE;
    private static final int ACROSS = LAYER_SIDE / CELL;
    private static final int CHANNELS = 4;

    /** Cells of a layer. */
    public static final int PER_LAYER = ACROSS * ACROSS;

    /** Numbers of a layer. */
    public static final int LAYER_NUMBERS = CHANNELS * LAYER_SIDE * LAYER_SIDE;

    private final List<TileGrid> grids;
    private final NumberFormat format;
    private final int slices;
    private final int columns;
    // Beside Java's heap, which would move them about.
    private final List<ByteBuffer> layers = new ArrayList<>();
    private final float[][] lists;
    private int cells;

    /** @param grids of the levels, the finest first */
    public TileCells(List<TileGrid> grids, NumberFormat format) {
        this.grids = List.copyOf(grids);
        this.format = format;
        this.slices = grids.get(0).slices();
        this.columns = grids.get(0).columns();
        this.lists = new float[grids.size() * slices][2 * grids.get(0).perSlice()];
        // Who looks into nothing still reads a texture.
        layers.add(newLayer());
    }

    /** Layers that some tiles fill. */
    public static int layers(long tiles) {
        return (int) Math.max(1, (tiles + PER_LAYER - 1) / PER_LAYER);
    }

    /** Shape of the texels of some tiles, as numbers of 32 bits. */
    static ArrayLayout texels(long tiles) {
        return ArrayLayout.layered("colorTexels", LAYER_SIDE, LAYER_SIDE, layers(tiles), CHANNELS)
                .linear();
    }

    /** What the shader is compiled with and told of any table. */
    public static ShaderTables.Builder define(ShaderTables.Builder tables, TileGrid finest) {
        return tables.define("COLOR_SLICES", finest.slices())
                .define("COLOR_TILE_SIDE", (float) TileGrid.SIDE)
                .define("COLOR_LAYER_SIDE", (float) LAYER_SIDE)
                .reals("perColorTiles", 1.0 / finest.columns(), 1.0 / finest.rows())
                .reals("colorSlicesPerUnit", 1 / finest.design().sliceStep());
    }

    /** An empty layer. */
    public ByteBuffer newLayer() {
        return ByteBuffer.allocateDirect(LAYER_NUMBERS * format.bytes()).order(ByteOrder.nativeOrder());
    }

    /**
     * Adds a tile.
     *
     * @return the layer that has it
     */
    public int add(int level, int tile, byte[] coefficients) {
        int layer = cells / PER_LAYER;
        if (layer == layers.size()) {
            layers.add(newLayer());
        }
        for (int row = 0; row < CELL; row++) {
            layers.get(layer).put(begin(cells, row), coefficients, row * rowBytes(), rowBytes());
        }
        cells++;
        TileGrid grid = grids.get(level);
        int slice = level * slices + tile / grid.perSlice();
        lists[slice][listed(grid, tile)] = cells;
        if (slice > level * slices) {
            lists[slice - 1][listed(grid, tile) + 1] = cells;
        }
        return layer;
    }

    private int rowBytes() {
        return CHANNELS * format.bytes() * CELL;
    }

    /** First byte of a row of a cell in its layer. */
    private int begin(int cell, int row) {
        int inLayer = cell % PER_LAYER;
        int top = inLayer / ACROSS * CELL;
        return CHANNELS * format.bytes() * ((top + row) * LAYER_SIDE + inLayer % ACROSS * CELL);
    }

    /** Where a tile stands in the list of its slice. */
    private int listed(TileGrid grid, int tile) {
        int inSlice = tile % grid.perSlice();
        return 2 * (inSlice / grid.columns() * columns + inSlice % grid.columns());
    }

    /** As {@link TableLookUp.Tiles#coefficient}, of a tile that was added. */
    public float coefficient(int level, int tile, int index) {
        TileGrid grid = grids.get(level);
        int cell = (int) lists[level * slices + tile / grid.perSlice()][listed(grid, tile)] - 1;
        int row = CHANNELS * CELL;
        int number = begin(cell, index / row) / format.bytes() + index % row;
        return format.decoded(layers.get(cell / PER_LAYER), number);
    }

    /** The layers of texels, each of {@link #LAYER_NUMBERS}. */
    public List<ByteBuffer> layers() {
        return layers;
    }

    /** Cells by tile, of each slice of each level. */
    public float[][] lists() {
        return lists;
    }

    /** Puts both into a shader's tables, as numbers of 32 bits. */
    void putInto(ShaderTables.Builder tables) {
        tables.array(new TableArray(texels(cells), layer -> format.floats(layers.get(layer))))
                .array(new TableArray(grids.get(0).tileList(grids.size()), layer -> FloatBuffer.wrap(lists[layer])));
    }
}
