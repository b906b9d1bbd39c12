package sunbeam.precompute.colortable;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.optics.DirectionPair;

/** Looks colors up in texels of {@link TableBaking} as the shader does (shaders/method/table.glsl), in double precision. */
final class TableLookUp {
    private final TableTiles tiles;
    private final TableBaking baking;
    private final float[][] layers;
    private final Map<Integer, Integer> cells = new HashMap<>();

    /** @param layers texels of a baking of these tiles */
    TableLookUp(TableTiles tiles, TableBaking baking, float[][] layers) {
        this.tiles = tiles;
        this.baking = baking;
        this.layers = layers;
        List<Integer> numbers = tiles.numbers();
        for (int cell = 0; cell < numbers.size(); cell++) {
            cells.put(numbers.get(cell), cell);
        }
    }

    /** X, Y, Z of a pair that the tiles were made for. */
    double[] xyz(DirectionPair pair) {
        double[] place = tiles.space().place(pair.u(), pair.v(), pair.w());
        double x = (place[0] - tiles.originX()) / tiles.design().step();
        double y = (place[1] - tiles.originY()) / tiles.design().step();
        if (tiles.slices() == 1) {
            return squared(x, y, 0);
        }
        double at = -pair.w() / tiles.design().sliceStep();
        int first = Math.max(0, Math.min((int) Math.floor(at) - 1, tiles.slices() - TableDesign.TAPS));
        double[] xyz = new double[3];
        for (int tap = 0; tap < TableDesign.TAPS; tap++) {
            double weight = TableDesign.lagrange(at - first, tap);
            double[] slice = squared(x, y, first + tap);
            for (int c = 0; c < 3; c++) {
                xyz[c] += weight * slice[c];
            }
        }
        return xyz;
    }

    private double[] squared(double x, double y, int slice) {
        int side = tiles.side();
        int column = (int) Math.floor(x / side);
        int row = (int) Math.floor(y / side);
        // A tile begins a texel before its own, as do the spline's four.
        int cell = cells.get(row * tiles.columns() + column);
        int left = baking.left(cell) + (int) Math.floor(x) - column * side;
        int top = baking.top(cell) + (int) Math.floor(y) - row * side;
        double[] across = CubicSpline.weights(x - Math.floor(x));
        double[] down = CubicSpline.weights(y - Math.floor(y));
        double[] xyz = new double[3];
        for (int c = 0; c < 3; c++) {
            double root = 0;
            for (int i = 0; i < 16; i++) {
                root += down[i >> 2] * across[i & 3] * layers[slice][baking.texel(left + (i & 3), top + (i >> 2)) + c];
            }
            xyz[c] = root * root;
        }
        return xyz;
    }
}
