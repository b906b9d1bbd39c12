package sunbeam.precompute.colortable;

import java.util.List;
import sunbeam.precompute.numerics.Lagrange;

/** Look-up of colors in tiles, as in shaders/include/color_table.glsl, in double precision. */
public record TableLookUp(List<TileGrid> grids, NumberFormat numbers, Tiles tiles) {
    private static final int SIDE = TileGrid.SIDE;
    private static final int STORED_SIDE = TileGrid.STORED_SIDE;
    private static final int CHANNELS = 4;
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
            double weight = grid.taps() == 1 ? 1 : Lagrange.weight(at - first, tap, TableDesign.TAPS);
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
            int texel = ((int) y + (i >> 2)) * STORED_SIDE + (int) x + (i & 3);
            for (int c = 0; weight != 0 && c < COLORS; c++) {
                roots[c] += weight * tiles.coefficient(level, tile, CHANNELS * texel + c);
            }
        }
        return roots;
    }
}
