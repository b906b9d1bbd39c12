package sunbeam.precompute.colortable;

import java.util.List;

/** Looks colors up in tiles of levels as shaders/method/table_levels.glsl does, in double precision. */
public final class LevelLookUp {
    private static final int SIDE = LevelGrid.SIDE;
    private static final int STORED_SIDE = LevelGrid.STORED_SIDE;
    private static final int CHANNELS = 4;
    private static final int COLORS = 3;
    // The shader's: what lies beyond all tiles is looked up at their edge.
    private static final double INSIDE = 0.01;

    private final TableLevels levels;
    private final List<LevelGrid> grids;
    private final Tiles tiles;

    /** Where tiles are. */
    @FunctionalInterface
    public interface Tiles {
        /** The coefficients of a tile that exists: {@link LevelBaking#TILE_NUMBERS} of the levels' format. */
        byte[] of(int level, int tile);
    }

    public LevelLookUp(TableLevels levels, Tiles tiles) {
        this.levels = levels;
        this.grids = levels.levels().stream().map(LevelGrid::of).toList();
        this.tiles = tiles;
    }

    /** X, Y, Z of power at a place whose tiles exist. */
    public double[] xyz(int level, double u, double v, double w) {
        LevelGrid grid = grids.get(level);
        double x = texel(grid, u);
        double y = texel(grid, v);
        int column = (int) (x / SIDE);
        int row = (int) (y / SIDE);
        double at = Math.max(0, -w) / grid.design().sliceStep();
        int first = grid.firstSlice(at);
        double[] xyz = new double[COLORS];
        for (int tap = 0; tap < TableDesign.TAPS; tap++) {
            byte[] tile = tiles.of(level, ((first + tap) * grid.columns() + row) * grid.columns() + column);
            double weight = TableDesign.lagrange(at - first, tap);
            for (int c = 0; c < COLORS; c++) {
                double root = root(tile, grid.interpolation(), x - column * SIDE, y - row * SIDE, c);
                xyz[c] += weight * root * root;
            }
        }
        double scale =
                levels.levels().get(level).scale() / Math.pow(levels.numbers().scale(), 2);
        for (int c = 0; c < COLORS; c++) {
            xyz[c] *= scale;
        }
        return xyz;
    }

    private static double texel(LevelGrid grid, double coordinate) {
        double texel = (coordinate - grid.firstCoefficient()) / grid.design().step();
        return Math.max(SIDE, Math.min(SIDE * (grid.columns() - 1) - INSIDE, texel));
    }

    private double root(byte[] tile, Interpolation interpolation, double x, double y, int channel) {
        double[] across = interpolation.weights(x - (int) x);
        double[] down = interpolation.weights(y - (int) y);
        double root = 0;
        for (int i = 0; i < 16; i++) {
            // A tile begins a texel before its own, as do the spline's four.
            int texel = ((int) y + (i >> 2)) * STORED_SIDE + (int) x + (i & 3);
            double weight = down[i >> 2] * across[i & 3];
            root += weight == 0 ? 0 : weight * levels.numbers().decoded(tile, CHANNELS * texel + channel);
        }
        return root;
    }
}
