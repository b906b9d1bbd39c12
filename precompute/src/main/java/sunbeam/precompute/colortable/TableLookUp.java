package sunbeam.precompute.colortable;

import java.util.List;

/** Looks colors up in tiles as shaders/include/color_table.glsl does, in double precision. */
public final class TableLookUp {
    private static final int SIDE = TileGrid.SIDE;
    private static final int STORED_SIDE = TileGrid.STORED_SIDE;
    private static final int CHANNELS = 4;
    private static final int COLORS = 3;
    // The shader's: what lies beyond all tiles is looked up at their edge.
    private static final double INSIDE = 0.01;

    private final List<TileGrid> grids;
    private final NumberFormat numbers;
    private final Tiles tiles;

    /** Where tiles are. */
    @FunctionalInterface
    public interface Tiles {
        /** The coefficients of a tile that exists: {@link LevelBaking#TILE_NUMBERS} of the table's format. */
        byte[] of(int level, int tile);
    }

    /** @param grids of the table's levels */
    public TableLookUp(List<TileGrid> grids, NumberFormat numbers, Tiles tiles) {
        this.grids = List.copyOf(grids);
        this.numbers = numbers;
        this.tiles = tiles;
    }

    /** X, Y, Z of power at a place whose tiles exist, before the level's scale. */
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
            byte[] tile = tiles.of(level, (first + tap) * grid.perSlice() + row * grid.columns() + column);
            double weight = grid.taps() == 1 ? 1 : TableDesign.lagrange(at - first, tap);
            for (int c = 0; c < COLORS; c++) {
                double root = root(tile, grid.interpolation(), x - column * SIDE, y - row * SIDE, c);
                xyz[c] += weight * root * root;
            }
        }
        for (int c = 0; c < COLORS; c++) {
            // Between dark slices polynomials may pass below nothing.
            xyz[c] = Math.max(0, xyz[c] / Math.pow(numbers.scale(), 2));
        }
        return xyz;
    }

    private static double inside(double texel, int tilesAcross) {
        return Math.max(SIDE, Math.min(SIDE * (tilesAcross - 1) - INSIDE, texel));
    }

    private double root(byte[] tile, Interpolation interpolation, double x, double y, int channel) {
        double[] across = interpolation.weights(x - (int) x);
        double[] down = interpolation.weights(y - (int) y);
        double root = 0;
        for (int i = 0; i < 16; i++) {
            // A tile begins a texel before its own, as do the spline's four.
            int texel = ((int) y + (i >> 2)) * STORED_SIDE + (int) x + (i & 3);
            double weight = down[i >> 2] * across[i & 3];
            root += weight == 0 ? 0 : weight * numbers.decoded(tile, CHANNELS * texel + channel);
        }
        return root;
    }
}
