package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.TableArray;

/**
 * Makes the texels of a table: coefficients of cubic B-splines through the square roots of X, Y and Z. Roots, because a
 * spline rings: beside a peak of 1 its error falls by 3.7 a texel, and of what is as dark as 1e-6 nothing would be left; in
 * roots that is 1e-3.
 */
public final class TableBaking {
    private static final int CHANNELS = 4;

    private final TableTiles tiles;
    private final int cellsAcross;
    private final int cellsDown;

    /** @param tiles that are to be made */
    public TableBaking(TableTiles tiles) {
        this.tiles = tiles;
        int count = Math.max(1, tiles.numbers().size());
        this.cellsAcross = (int) Math.ceil(Math.sqrt(count));
        this.cellsDown = (count + cellsAcross - 1) / cellsAcross;
    }

    /** Shape of the texels: tiles beside each other, one layer a slice. */
    public ArrayLayout texelsLayout() {
        int side = tiles.storedSide();
        return ArrayLayout.layered("colorTexels", cellsAcross * side, cellsDown * side, tiles.slices(), CHANNELS)
                .linear();
    }

    /** Shape of the list of tiles: for each that there could be its first texel and, for those that exist, 1. */
    public ArrayLayout tilesLayout() {
        return ArrayLayout.flat("colorTiles", tiles.columns(), tiles.rows(), CHANNELS);
    }

    /** What the texels take, and making them. */
    public MemoryNeed memory() {
        long square = (long) tiles.evaluatedSide() * tiles.evaluatedSide();
        // Of one tile three planes; of the places that are evaluated at once their numbers, places and colors.
        long together = Math.min(ColorSource.BATCH, square * tiles.numbers().size() * tiles.slices());
        long work = square * 3 * Float.BYTES + together * (Integer.BYTES + 6L * Float.BYTES + 3L * Double.BYTES);
        return MemoryNeed.of(texelsLayout().bytes() + work, List.of(texelsLayout(), tilesLayout()));
    }

    /** Where the tiles lie among the texels. */
    public TableArray tileList() {
        float[] list = new float[CHANNELS * tiles.columns() * tiles.rows()];
        int cell = 0;
        for (int number : tiles.numbers()) {
            list[CHANNELS * number] = left(cell);
            list[CHANNELS * number + 1] = top(cell);
            list[CHANNELS * number + 2] = 1;
            cell++;
        }
        return TableArray.of(tilesLayout(), list);
    }

    /** Texels to the left of a tile's, of so many before it. */
    int left(int cell) {
        return cell % cellsAcross * tiles.storedSide();
    }

    /** Texels above a tile's. */
    int top(int cell) {
        int row = cell / cellsAcross;
        return row * tiles.storedSide();
    }

    /** Where a texel begins in its layer. */
    int texel(int x, int y) {
        return CHANNELS * (y * cellsAcross * tiles.storedSide() + x);
    }

    /** The texels of all slices, as the shader has them. */
    TableArray texels(float[][] layers) {
        return TableArray.computed(texelsLayout(), layer -> layers[layer]);
    }

    /** Evaluates all texels. */
    float[][] layers(ColorSource source) {
        ArrayLayout layout = texelsLayout();
        float[][] layers = new float[layout.layers()][layout.floatsPerLayer()];
        List<Part> parts = new ArrayList<>();
        long places = 0;
        int cell = 0;
        for (int number : tiles.numbers()) {
            for (int slice = 0; slice < tiles.slices(); slice++) {
                BitSet mask = tiles.mask(number, slice);
                if (!mask.isEmpty()) {
                    if (places + mask.cardinality() > ColorSource.BATCH) {
                        evaluate(parts, source, layers);
                        parts.clear();
                        places = 0;
                    }
                    parts.add(new Part(number, slice, cell, inOrder(mask, tiles.evaluatedSide()), mask));
                    places += mask.cardinality();
                }
            }
            cell++;
        }
        evaluate(parts, source, layers);
        return layers;
    }

    /** Texels of a tile's evaluated square that are needed in a slice. */
    private record Part(int number, int slice, int cell, int[] texels, BitSet mask) {}

    private void evaluate(List<Part> parts, ColorSource source, float[][] layers) {
        int count = parts.stream().mapToInt(part -> part.texels.length).sum();
        float[] places = new float[3 * count];
        int first = 0;
        for (Part part : parts) {
            int start = first;
            IntStream.range(0, part.texels.length).parallel().forEach(i -> {
                double[] uvw = tiles.uvw(part.number, part.slice, part.texels[i]);
                for (int axis = 0; axis < 3; axis++) {
                    places[3 * (start + i) + axis] = (float) uvw[axis];
                }
            });
            first += part.texels.length;
        }
        float[] xyz = source.xyz(places);
        first = 0;
        for (Part part : parts) {
            put(layers[part.slice], part.cell, coefficients(part, xyz, first));
            first += part.texels.length;
        }
    }

    /** Coefficients over a tile's evaluated square, one plane a channel. */
    private float[][] coefficients(Part part, float[] xyz, int first) {
        int side = tiles.evaluatedSide();
        float[][] planes = new float[3][side * side];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < part.texels.length; i++) {
                // A sum of the expansion's terms may leave a dark direction a little below nothing.
                planes[c][part.texels[i]] = (float) Math.sqrt(Math.max(0, xyz[3 * (first + i) + c]));
            }
        }
        Arrays.stream(planes).parallel().forEach(plane -> {
            alongRuns(plane, part.mask, 1, side);
            alongRuns(plane, part.mask, side, 1);
        });
        return planes;
    }

    /**
     * Texels in Morton's order (quarter by quarter of the square, and each of these so again): neighbors, which read nearly the
     * same, are asked for together.
     */
    private static int[] inOrder(BitSet mask, int side) {
        long[] keyed = new long[mask.cardinality()];
        int count = 0;
        for (int i = mask.nextSetBit(0); i >= 0; i = mask.nextSetBit(i + 1)) {
            keyed[count++] = (MortonOrder.number(i % side, i / side) << Integer.SIZE) | i;
        }
        Arrays.parallelSort(keyed);
        return Arrays.stream(keyed).mapToInt(key -> (int) key).toArray();
    }

    /** Filters all runs of neighboring texels that were evaluated. */
    private void alongRuns(float[] plane, BitSet mask, int stride, int lineStride) {
        int side = tiles.evaluatedSide();
        for (int line = 0; line < side; line++) {
            int start = 0;
            for (int i = 0; i <= side; i++) {
                if (i == side || !mask.get(line * lineStride + i * stride)) {
                    CubicSpline.toCoefficients(plane, line * lineStride + start * stride, stride, i - start);
                    start = i + 1;
                }
            }
        }
    }

    private void put(float[] layer, int cell, float[][] planes) {
        int side = tiles.storedSide();
        int evaluated = tiles.evaluatedSide();
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                int from = (row + TableTiles.MARGIN) * evaluated + column + TableTiles.MARGIN;
                int to = texel(left(cell) + column, top(cell) + row);
                for (int c = 0; c < 3; c++) {
                    layer[to + c] = planes[c][from];
                }
            }
        }
    }
}
