package sunbeam.precompute.colortable;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.TableArray;

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
    // Direct buffers, which the garbage collector does not move.
    private final List<ByteBuffer> layers = new ArrayList<>();
    private final float[][] pageTable;
    private int pages;

    public AtlasPages(List<TileGrid> grids, NumberFormat format) {
        this.grids = List.copyOf(grids);
        this.format = format;
        this.pageTable = new float[grids.size() * finest().slices()][2 * finest().perSlice()];
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
        int rowBytes = CHANNELS * format.bytes() * PAGE_SIDE;
        for (int row = 0; row < PAGE_SIDE; row++) {
            layers.get(layer).put(begin(pages, row), coefficients, row * rowBytes, rowBytes);
        }
        pages++;
        TileGrid grid = grids.get(level);
        int slice = level * finest().slices() + tile / grid.perSlice();
        pageTable[slice][indexInTable(grid, tile)] = pages;
        if (tile >= grid.perSlice()) {
            pageTable[slice - 1][indexInTable(grid, tile) + 1] = pages;
        }
        return layer;
    }

    private int begin(int page, int row) {
        int inLayer = page % PER_LAYER;
        int top = inLayer / PAGES_ACROSS * PAGE_SIDE;
        return CHANNELS * format.bytes() * ((top + row) * LAYER_SIDE + inLayer % PAGES_ACROSS * PAGE_SIDE);
    }

    private int indexInTable(TileGrid grid, int tile) {
        int inSlice = tile % grid.perSlice();
        return 2 * (inSlice / grid.columns() * finest().columns() + inSlice % grid.columns());
    }

    private float coefficient(int level, int tile, int index) {
        TileGrid grid = grids.get(level);
        int page = (int) pageTable[level * finest().slices() + tile / grid.perSlice()][indexInTable(grid, tile)] - 1;
        int row = CHANNELS * PAGE_SIDE;
        return format.decoded(layers.get(page / PER_LAYER), begin(page, index / row) / format.bytes() + index % row);
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
        return grids.get(0);
    }

    /** Returns the factor of the coefficients' squares that gives power. */
    double scale() {
        return Math.pow(format.scale(), -2);
    }

    void putInto(ShaderTables.Builder tables) {
        tables.array(new TableArray(texels(pages), layer -> format.floats(layers.get(layer))))
                .array(new TableArray(finest().tileList(grids.size()), layer -> FloatBuffer.wrap(pageTable[layer])));
    }

    /** Look-up of colors in tiles, as in shaders/include/color_table.glsl, in double precision. */
    public record TableLookUp(List<TileGrid> grids, NumberFormat numbers, Tiles tiles) {
        private static final int SIDE = TileGrid.SIDE;
        private static final int COLORS = 3;
        // From the last tile's edge, in texels, as in the shader.
        private static final double EDGE_MARGIN = 0.01;

        @FunctionalInterface
        public interface Tiles {
            /** Returns a coefficient of an existing tile, times {@link NumberFormat#scale()}, by its index in the tile. */
            float coefficient(int level, int tile, int index);
        }

        /** Returns X, Y, Z of power, not yet multiplied by the level's scale. The tiles must exist. */
        public double[] xyz(int level, double u, double v, double w) {
            TileGrid grid = grids.get(level);
            double[] place = grid.space().place(u, v, w);
            double x = inside((place[0] - grid.firstX()) / grid.design().step(), grid.columns());
            double y = inside((place[1] - grid.firstY()) / grid.design().step(), grid.rows());
            int column = (int) (x / SIDE);
            int row = (int) (y / SIDE);
            double at = Math.max(0, -w) / grid.design().sliceStep();
            int first = grid.firstSlice(at);
            double[] xyz = new double[COLORS];
            for (int tap = 0; tap < grid.taps(); tap++) {
                int tile = (first + tap) * grid.perSlice() + row * grid.columns() + column;
                double weight = Lagrange.weight(at - first, tap, grid.taps());
                double[] roots = roots(level, tile, x - column * SIDE, y - row * SIDE);
                for (int c = 0; c < COLORS; c++) {
                    xyz[c] += weight * roots[c] * roots[c];
                }
            }
            for (int c = 0; c < COLORS; c++) {
                // The polynomial in w may be negative between dark slices.
                xyz[c] = Math.max(0, xyz[c] / Math.pow(numbers.scale(), 2));
            }
            return xyz;
        }

        private static double inside(double texel, int tilesAcross) {
            return Math.max(SIDE, Math.min(SIDE * (tilesAcross - 1) - EDGE_MARGIN, texel));
        }

        private double[] roots(int level, int tile, double x, double y) {
            Interpolation interpolation = grids.get(level).interpolation();
            double[] across = interpolation.weights(x - (int) x);
            double[] down = interpolation.weights(y - (int) y);
            double[] roots = new double[COLORS];
            for (int i = 0; i < 16; i++) {
                double weight = down[i >> 2] * across[i & 3];
                // The stored tile begins one texel before the first one that the tile owns.
                int texel = ((int) y + (i >> 2)) * PAGE_SIDE + (int) x + (i & 3);
                for (int c = 0; weight != 0 && c < COLORS; c++) {
                    roots[c] += weight * tiles.coefficient(level, tile, CHANNELS * texel + c);
                }
            }
            return roots;
        }
    }
}
