package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * Texels of a level that are asked for. Columns are numbered in {@link MortonOrder}: those that read the same, or nearly so, follow each other.
 */
final class TexelColumns implements ColorColumns {
    private static final int SIDE = TileGrid.SIDE;
    private static final int COLORS = 3;

    private final TileGrid grid;
    private final TileColumn[] tiles;
    private final int[] slices;

    /**
     * Some texels of a tile.
     *
     * @param number of the tile
     * @param texels row by row
     * @param roots takes square roots of X, Y and Z of all its texels
     */
    record Needed(int number, BitSet texels, float[] roots) {}

    /**
     * Tiles of different slices above each other.
     *
     * @param column of the tiles
     * @param row of the tiles
     * @param needed by the index of the slice; null where there is none
     * @param first of these indices that there is one of
     * @param end behind the last
     */
    private record TileColumn(int column, int row, Needed[] needed, int first, int end) {
        static TileColumn of(int column, int row, Needed[] needed) {
            int first = 0;
            while (needed[first] == null) {
                first++;
            }
            int end = needed.length;
            while (needed[end - 1] == null) {
                end--;
            }
            return new TileColumn(column, row, needed, first, end);
        }
    }

    TexelColumns(TileGrid grid, List<Needed> needed) {
        this.grid = grid;
        this.slices = needed.stream()
                .filter(tile -> !tile.texels.isEmpty())
                .mapToInt(tile -> grid.place(tile.number)[2])
                .sorted()
                .distinct()
                .toArray();
        int[] indices = new int[grid.slices()];
        for (int i = 0; i < slices.length; i++) {
            indices[slices[i]] = i;
        }
        Map<Long, Needed[]> byPlace = new TreeMap<>();
        for (Needed tile : needed) {
            if (!tile.texels.isEmpty()) {
                int[] place = grid.place(tile.number);
                byPlace.computeIfAbsent(MortonOrder.number(place[0], place[1]), number -> new Needed[slices.length])[
                        indices[place[2]]] = tile;
            }
        }
        this.tiles = byPlace.entrySet().stream()
                .map(entry -> TileColumn.of(
                        MortonOrder.x(Math.toIntExact(entry.getKey())),
                        MortonOrder.y(Math.toIntExact(entry.getKey())),
                        entry.getValue()))
                .toArray(TileColumn[]::new);
    }

    @Override
    public int count() {
        return Math.multiplyExact(tiles.length, SIDE * SIDE);
    }

    @Override
    public void locate(int column, float[] uv) {
        double[] uvw = uvw(column, 0);
        uv[0] = (float) uvw[0];
        uv[1] = (float) uvw[1];
    }

    private double[] uvw(int column, int slice) {
        TileColumn tile = tiles[column / (SIDE * SIDE)];
        int inTile = column % (SIDE * SIDE);
        return grid.uvw(tile.column * SIDE + MortonOrder.x(inTile), tile.row * SIDE + MortonOrder.y(inTile), slice);
    }

    /** Has all of them evaluated: slice by slice, or each at a w of its own where one slice has them all. */
    void evaluate(ColorSource source) {
        if (grid.space() instanceof TableSpace.AllLights) {
            source.evaluate(this);
            return;
        }
        int[] asked = IntStream.range(0, count())
                .filter(column -> tiles[column / (SIDE * SIDE)].needed[0].texels.get(inTile(column)))
                .toArray();
        for (int start = 0; start < asked.length; start += ColorSource.BATCH) {
            int[] some = Arrays.copyOfRange(asked, start, Math.min(asked.length, start + ColorSource.BATCH));
            float[] places = new float[COLORS * some.length];
            IntStream.range(0, some.length).parallel().forEach(i -> {
                double[] uvw = uvw(some[i], 0);
                for (int axis = 0; axis < COLORS; axis++) {
                    places[COLORS * i + axis] = (float) uvw[axis];
                }
            });
            float[] xyz = source.xyz(places);
            for (int i = 0; i < some.length; i++) {
                putRoots(some[i], 0, root(xyz[COLORS * i]), root(xyz[COLORS * i + 1]), root(xyz[COLORS * i + 2]));
            }
        }
    }

    /** A sum of the expansion's terms may leave a dark direction a little below nothing. */
    private static double root(float color) {
        return Math.sqrt(Math.max(0, color));
    }

    @Override
    public double[] depths() {
        double[] depths = new double[slices.length];
        for (int i = 0; i < depths.length; i++) {
            depths[i] = slices[i] * grid.design().sliceStep();
        }
        return depths;
    }

    @Override
    public int asked(int column, int[] asked) {
        TileColumn tile = tiles[column / (SIDE * SIDE)];
        int texel = inTile(column);
        int count = 0;
        for (int slice = tile.first; slice < tile.end; slice++) {
            Needed needed = tile.needed[slice];
            if (needed != null && needed.texels.get(texel)) {
                asked[count++] = slice;
            }
        }
        return count;
    }

    /** Of a column's texel, row by row. */
    private static int inTile(int column) {
        int inTile = column % (SIDE * SIDE);
        return MortonOrder.y(inTile) * SIDE + MortonOrder.x(inTile);
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        float[] roots = tiles[column / (SIDE * SIDE)].needed[slice].roots;
        int at = COLORS * inTile(column);
        roots[at] = (float) Math.abs(x);
        roots[at + 1] = (float) Math.abs(y);
        roots[at + 2] = (float) Math.abs(z);
    }
}
