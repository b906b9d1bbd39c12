package sunbeam.precompute.colortable;

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

    private final TablePages pages;
    private final int cellsAcross;
    private final int cellsDown;

    /** @param pages that are to be made */
    public TableBaking(TablePages pages) {
        this.pages = pages;
        int count = Math.max(1, pages.numbers().size());
        this.cellsAcross = (int) Math.ceil(Math.sqrt(count));
        this.cellsDown = (count + cellsAcross - 1) / cellsAcross;
    }

    /** Shape of the texels: pages beside each other, one layer a slice. */
    public ArrayLayout texelsLayout() {
        int side = pages.storedSide();
        return ArrayLayout.layered("colorTexels", cellsAcross * side, cellsDown * side, pages.slices(), CHANNELS)
                .linear();
    }

    /** Shape of the list of pages: for each that there could be its first texel and, for those that exist, 1. */
    public ArrayLayout pagesLayout() {
        return ArrayLayout.flat("colorPages", pages.columns(), pages.rows(), CHANNELS);
    }

    /** What the texels take, and making them. */
    public MemoryNeed memory() {
        long square = (long) pages.evaluatedSide() * pages.evaluatedSide();
        // Of one page its mask's numbers, places, colors and planes, beside all texels.
        long work = square * (Integer.BYTES + 9L * Float.BYTES);
        return MemoryNeed.of(texelsLayout().bytes() + work, List.of(texelsLayout(), pagesLayout()));
    }

    /** Where the pages lie among the texels. */
    public TableArray pageList() {
        float[] list = new float[CHANNELS * pages.columns() * pages.rows()];
        int cell = 0;
        for (int number : pages.numbers()) {
            list[CHANNELS * number] = left(cell);
            list[CHANNELS * number + 1] = top(cell);
            list[CHANNELS * number + 2] = 1;
            cell++;
        }
        return TableArray.of(pagesLayout(), list);
    }

    /** Texels to the left of a page's, of so many before it. */
    int left(int cell) {
        return cell % cellsAcross * pages.storedSide();
    }

    /** Texels above a page's. */
    int top(int cell) {
        int row = cell / cellsAcross;
        return row * pages.storedSide();
    }

    /** Where a texel begins in its layer. */
    int texel(int x, int y) {
        return CHANNELS * (y * cellsAcross * pages.storedSide() + x);
    }

    /** The texels of all slices, as the shader has them. */
    TableArray texels(float[][] layers) {
        return TableArray.computed(texelsLayout(), layer -> layers[layer]);
    }

    /** Evaluates all texels, slice by slice. */
    float[][] layers(ColorSource source) {
        ArrayLayout layout = texelsLayout();
        float[][] layers = new float[layout.layers()][layout.floatsPerLayer()];
        int cell = 0;
        for (int number : pages.numbers()) {
            for (int slice = 0; slice < pages.slices(); slice++) {
                BitSet mask = pages.mask(number, slice);
                if (!mask.isEmpty()) {
                    put(layers[slice], cell, coefficients(source, number, slice, mask));
                }
            }
            cell++;
        }
        return layers;
    }

    /** Coefficients over a page's evaluated square, one plane a channel. */
    private float[][] coefficients(ColorSource source, int number, int slice, BitSet mask) {
        int side = pages.evaluatedSide();
        int[] wanted = inOrder(mask, side);
        float[] places = new float[3 * wanted.length];
        IntStream.range(0, wanted.length).parallel().forEach(i -> {
            double[] uvw = pages.uvw(number, slice, wanted[i]);
            for (int axis = 0; axis < 3; axis++) {
                places[3 * i + axis] = (float) uvw[axis];
            }
        });
        float[] xyz = source.xyz(places);
        float[][] planes = new float[3][side * side];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < wanted.length; i++) {
                // A sum of the expansion's terms may leave a dark direction a little below nothing.
                planes[c][wanted[i]] = (float) Math.sqrt(Math.max(0, xyz[3 * i + c]));
            }
        }
        Arrays.stream(planes).parallel().forEach(plane -> {
            alongRuns(plane, mask, 1, side);
            alongRuns(plane, mask, side, 1);
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
        int side = pages.evaluatedSide();
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
        int side = pages.storedSide();
        int evaluated = pages.evaluatedSide();
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                int from = (row + TablePages.MARGIN) * evaluated + column + TablePages.MARGIN;
                int to = texel(left(cell) + column, top(cell) + row);
                for (int c = 0; c < 3; c++) {
                    layer[to + c] = planes[c][from];
                }
            }
        }
    }
}
