package sunbeam.precompute.radial;

import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Powers of a surface's DFT bins, each as the values of its terms, which lie side by side in memory.
 *
 * @param periodX reciprocal of the distance between columns, meters, which is the surface's width unless bins were decimated: a column's
 *     frequency is (firstX + column) / periodX
 * @param firstX number of the first column's DFT bin
 * @param powers {@code [row][column][term]}, each bin padded with zeros to {@link #stride()}
 */
record SpectrumPlane(
        double periodX, double periodY, int firstX, int firstY, int columns, int rows, int terms, double[] powers) {
    /** Number of terms that loops sum at once, in registers. */
    static final int TOGETHER = 4;

    private static final int POINTS = 8;
    private static final int BEFORE = POINTS / 2 - 1;

    /** Interleaves the terms' fields, {@code [term][bin]}. */
    static SpectrumPlane of(
            double periodX, double periodY, int firstX, int firstY, int columns, int rows, double[][] fields) {
        int terms = fields.length;
        int stride = stride(terms);
        double[] powers = new double[Math.multiplyExact(stride, Math.multiplyExact(columns, rows))];
        IntStream.range(0, columns * rows).parallel().forEach(bin -> {
            for (int m = 0; m < terms; m++) {
                powers[bin * stride + m] = fields[m][bin];
            }
        });
        return new SpectrumPlane(periodX, periodY, firstX, firstY, columns, rows, terms, powers);
    }

    private static int stride(int terms) {
        return (terms + TOGETHER - 1) / TOGETHER * TOGETHER;
    }

    /** Values per bin: the terms, padded with zeros. */
    int stride() {
        return stride(terms);
    }

    /**
     * Returns bins that are farther apart by whole factors. Each power is distributed over eight bins by Lagrange weights of degree 7, so
     * that sums over Gaussians wider than the new spacing do not change.
     */
    SpectrumPlane decimated(int factorX, int factorY) {
        SpectrumPlane alongX = factorX == 1 ? this : decimatedX(factorX);
        return factorY == 1 ? alongX : alongX.transposed().decimatedX(factorY).transposed();
    }

    SpectrumPlane transposed() {
        double[] target = new double[powers.length];
        IntStream.range(0, columns).parallel().forEach(column -> {
            for (int row = 0; row < rows; row++) {
                System.arraycopy(
                        powers,
                        (row * columns + column) * stride(),
                        target,
                        (column * rows + row) * stride(),
                        stride());
            }
        });
        return new SpectrumPlane(periodY, periodX, firstY, firstX, rows, columns, terms, target);
    }

    private SpectrumPlane decimatedX(int factor) {
        int first = Math.floorDiv(firstX, factor) - BEFORE;
        int last = Math.floorDiv(firstX + columns - 1, factor) + POINTS - BEFORE;
        int count = last - first + 1;
        double[] sums = new double[Math.multiplyExact(Math.multiplyExact(rows, count), stride())];
        double[][] weights = IntStream.range(0, factor)
                .mapToObj(rest -> IntStream.range(0, POINTS)
                        .mapToDouble(k -> Lagrange.weight((double) rest / factor + BEFORE, k, POINTS))
                        .toArray())
                .toArray(double[][]::new);
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int column = 0; column < columns; column++) {
                int below = Math.floorDiv(firstX + column, factor);
                double[] shares = weights[Math.floorMod(firstX + column, factor)];
                for (int k = 0; k < POINTS; k++) {
                    int to = (row * count + below - BEFORE + k - first) * stride();
                    int from = (row * columns + column) * stride();
                    for (int m = 0; m < terms; m++) {
                        sums[to + m] += shares[k] * powers[from + m];
                    }
                }
            }
        });
        return new SpectrumPlane(periodX / factor, periodY, first, firstY, count, rows, terms, sums);
    }
}
