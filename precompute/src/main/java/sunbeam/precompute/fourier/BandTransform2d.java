package sunbeam.precompute.fourier;

import java.util.stream.IntStream;

/**
 * Two-dimensional inverse DFT of one period of a complex field, limited to a band of bins along each axis. The field is seen from above:
 * column indices grow with x, row indices with -y, so that
 *
 * <pre>F[jy, jx] = 1/(columns rows) sum field(column, row) exp(+2 pi i (jx column / columns - jy row / rows))</pre>
 *
 * Rows of the result are in ascending order of jy, columns in ascending order of jx. Runs on all cores.
 */
public final class BandTransform2d {
    private final int rows;
    private final BandTransform alongX;
    private final BandTransform alongY;

    /** Source of the field's samples. Must be thread-safe. */
    @FunctionalInterface
    public interface RowSource {
        void fill(int row, double[] real, double[] imaginary);
    }

    public BandTransform2d(int columns, int rows, Band bandX, Band bandY) {
        this.rows = rows;
        this.alongX = new BandTransform(columns, bandX);
        // Rows run downwards: bin jy of y is bin -jy of the row index. Descending row bins are ascending y bins.
        this.alongY = new BandTransform(rows, Band.of(-bandY.last(), -bandY.first()));
    }

    /** Returns {@code bandY.count() * bandX.count()} bins, row by row. */
    public ComplexVector transform(RowSource source) {
        int width = alongX.band().count();
        int height = alongY.band().count();
        ComplexVector half = ComplexVector.zeros(Math.multiplyExact(rows, width));
        IntStream.range(0, rows).parallel().forEach(row -> {
            ComplexVector work = alongX.workspace();
            source.fill(row, work.real(), work.imaginary());
            alongX.transform(work, half, row * width, 1);
        });
        ComplexVector result = ComplexVector.zeros(Math.multiplyExact(height, width));
        IntStream.range(0, width).parallel().forEach(column -> {
            ComplexVector work = alongY.workspace();
            for (int row = 0; row < rows; row++) {
                work.real()[row] = half.real()[row * width + column];
                work.imaginary()[row] = half.imaginary()[row * width + column];
            }
            alongY.transform(work, result, (height - 1) * width + column, -width);
        });
        return result;
    }
}
