package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Texels of a level that are asked for. Columns are numbered in {@link MortonOrder}: those that read the same, or nearly so, follow each other.
 */
final class TexelColumns implements ColorColumns {
    private static final int SIDE = LevelGrid.SIDE;
    private static final int COLORS = 3;

    private final LevelGrid grid;
    private final double origin;
    private final PageColumn[] pages;
    private final int[] slices;

    /**
     * Some texels of a page.
     *
     * @param number of the page
     * @param texels row by row
     * @param roots takes square roots of X, Y and Z of all its texels
     */
    record Needed(int number, BitSet texels, float[] roots) {}

    /**
     * Pages of different slices above each other.
     *
     * @param column of the pages
     * @param row of the pages
     * @param needed by the index of the slice; null where there is none
     * @param first of these indices that there is one of
     * @param end behind the last
     */
    private record PageColumn(int column, int row, Needed[] needed, int first, int end) {
        static PageColumn of(int column, int row, Needed[] needed) {
            int first = 0;
            while (needed[first] == null) {
                first++;
            }
            int end = needed.length;
            while (needed[end - 1] == null) {
                end--;
            }
            return new PageColumn(column, row, needed, first, end);
        }
    }

    TexelColumns(LevelGrid grid, List<Needed> needed) {
        this.grid = grid;
        this.origin = grid.origin();
        this.slices = needed.stream()
                .filter(page -> !page.texels.isEmpty())
                .mapToInt(page -> grid.place(page.number)[2])
                .sorted()
                .distinct()
                .toArray();
        int[] indices = new int[grid.design().slices()];
        for (int i = 0; i < slices.length; i++) {
            indices[slices[i]] = i;
        }
        Map<Long, Needed[]> byPlace = new TreeMap<>();
        for (Needed page : needed) {
            if (!page.texels.isEmpty()) {
                int[] place = grid.place(page.number);
                byPlace.computeIfAbsent(MortonOrder.number(place[0], place[1]), number -> new Needed[slices.length])[
                        indices[place[2]]] = page;
            }
        }
        this.pages = byPlace.entrySet().stream()
                .map(entry -> PageColumn.of(
                        MortonOrder.x(Math.toIntExact(entry.getKey())),
                        MortonOrder.y(Math.toIntExact(entry.getKey())),
                        entry.getValue()))
                .toArray(PageColumn[]::new);
    }

    @Override
    public int count() {
        return Math.multiplyExact(pages.length, SIDE * SIDE);
    }

    @Override
    public void locate(int column, float[] uv) {
        PageColumn page = pages[column / (SIDE * SIDE)];
        int inPage = column % (SIDE * SIDE);
        grid.put(page.column * SIDE + MortonOrder.x(inPage), page.row * SIDE + MortonOrder.y(inPage), origin, uv);
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
        PageColumn page = pages[column / (SIDE * SIDE)];
        int texel = inPage(column);
        int count = 0;
        for (int slice = page.first; slice < page.end; slice++) {
            Needed needed = page.needed[slice];
            if (needed != null && needed.texels.get(texel)) {
                asked[count++] = slice;
            }
        }
        return count;
    }

    /** Of a column's texel, row by row. */
    private static int inPage(int column) {
        int inPage = column % (SIDE * SIDE);
        return MortonOrder.y(inPage) * SIDE + MortonOrder.x(inPage);
    }

    @Override
    public void putRoots(int column, int slice, double x, double y, double z) {
        float[] roots = pages[column / (SIDE * SIDE)].needed[slice].roots;
        int at = COLORS * inPage(column);
        roots[at] = (float) Math.abs(x);
        roots[at + 1] = (float) Math.abs(y);
        roots[at + 2] = (float) Math.abs(z);
    }
}
