package sunbeam.precompute.rays;

import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Powers of a surface's DFT bins, in terms.
 *
 * @param periodX width of the surface, metres: a column's frequency is (firstX + column) / periodX
 * @param periodY height of the surface, metres
 * @param firstX number of the first column's bin
 * @param firstY number of the first row's bin
 * @param columns bins along x
 * @param rows bins along y
 * @param terms of each power
 * @param powers {@code [row][column][term]}, one after the other; zeros fill up each bin's terms to {@link #stride()}
 */
record BinPlane(
        double periodX, double periodY, int firstX, int firstY, int columns, int rows, int terms, double[] powers) {
    /** Terms that are summed at once. */
    static final int TOGETHER = 4;

    private static final int POINTS = 8;
    private static final int BEFORE = POINTS / 2 - 1;

    /** From one field a term. */
    static BinPlane of(
            double periodX, double periodY, int firstX, int firstY, int columns, int rows, double[][] fields) {
        int terms = fields.length;
        int stride = stride(terms);
        double[] powers = new double[Math.multiplyExact(stride, Math.multiplyExact(columns, rows))];
        IntStream.range(0, columns * rows).parallel().forEach(bin -> {
            for (int m = 0; m < terms; m++) {
                powers[bin * stride + m] = fields[m][bin];
            }
        });
        return new BinPlane(periodX, periodY, firstX, firstY, columns, rows, terms, powers);
    }

    private static int stride(int terms) {
        return (terms + TOGETHER - 1) / TOGETHER * TOGETHER;
    }

    /** Values a bin. */
    int stride() {
        return stride(terms);
    }

    /**
     * The same powers on fewer bins, so many times as far apart: each is divided among those beside it by the weights that
     * interpolate a polynomial of degree 7 where it lies, so that sums over Gaussians that are wide beside the distance stay.
     */
    BinPlane folded(int foldX, int foldY) {
        BinPlane alongX = foldX == 1 ? this : foldedX(foldX);
        return foldY == 1 ? alongX : alongX.transposed().foldedX(foldY).transposed();
    }

    /** Rows as columns. */
    BinPlane transposed() {
        double[] turned = new double[powers.length];
        IntStream.range(0, columns).parallel().forEach(column -> {
            for (int row = 0; row < rows; row++) {
                System.arraycopy(
                        powers,
                        (row * columns + column) * stride(),
                        turned,
                        (column * rows + row) * stride(),
                        stride());
            }
        });
        return new BinPlane(periodY, periodX, firstY, firstX, rows, columns, terms, turned);
    }

    private BinPlane foldedX(int fold) {
        int first = Math.floorDiv(firstX, fold) - BEFORE;
        int last = Math.floorDiv(firstX + columns - 1, fold) + POINTS - BEFORE;
        int count = last - first + 1;
        double[] sums = new double[Math.multiplyExact(Math.multiplyExact(rows, count), stride())];
        double[][] weights = IntStream.range(0, fold)
                .mapToObj(rest -> IntStream.range(0, POINTS)
                        .mapToDouble(k -> Lagrange.weight((double) rest / fold + BEFORE, k, POINTS))
                        .toArray())
                .toArray(double[][]::new);
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int column = 0; column < columns; column++) {
                int below = Math.floorDiv(firstX + column, fold);
                double[] shares = weights[Math.floorMod(firstX + column, fold)];
                for (int k = 0; k < POINTS; k++) {
                    int to = (row * count + below - BEFORE + k - first) * stride();
                    int from = (row * columns + column) * stride();
                    for (int m = 0; m < terms; m++) {
                        sums[to + m] += shares[k] * powers[from + m];
                    }
                }
            }
        });
        return new BinPlane(periodX / fold, periodY, first, firstY, count, rows, terms, sums);
    }
}
