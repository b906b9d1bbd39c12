package sunbeam.precompute.fourier;

import java.util.function.BiConsumer;
import java.util.stream.IntStream;

/**
 * Two-dimensional inverse DFT of one period of a field, limited to a band of bins along each axis. The field is seen from above: column
 * indices grow with x, row indices with -y, so that
 *
 * <pre>F[jy, jx] = 1/(columns rows) sum field(column, row) exp(+2 pi i (jx column / columns - jy row / rows))</pre>
 *
 * Rows of the result are in ascending order of jy, columns in ascending order of jx. Runs on all cores.
 */
public final class BandTransform2d {
    private final int rows;
    private final BandTransform alongX;
    private final BandTransform alongY;

    /** Source of the samples of a complex field. Must be thread-safe. */
    @FunctionalInterface
    public interface RowSource {
        void fill(int row, double[] real, double[] imaginary);
    }

    /** Source of the samples of a real field. Must be thread-safe. */
    @FunctionalInterface
    public interface RealRowSource {
        void fill(int row, double[] samples);
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
        forEachColumn(
                half, width, (column, work) -> alongY.transform(work, result, (height - 1) * width + column, -width));
        return result;
    }

    private void forEachColumn(ComplexVector half, int width, BiConsumer<Integer, ComplexVector> visitor) {
        IntStream.range(0, width).parallel().forEach(column -> {
            ComplexVector work = alongY.workspace();
            for (int row = 0; row < rows; row++) {
                work.real()[row] = half.real()[row * width + column];
                work.imaginary()[row] = half.imaginary()[row * width + column];
            }
            visitor.accept(column, work);
        });
    }

    /**
     * Returns the squared magnitudes of the bins of a real field, for bands that are symmetric about 0 and less than half the samples wide
     * on each side. Bins (jx, jy) and (-jx, -jy) are complex conjugates: two rows are transformed as one complex row, and only columns with
     * jx >= 0.
     */
    public double[] powers(RealRowSource source) {
        int reachX = alongX.band().last();
        int width = reachX + 1;
        ComplexVector half = ComplexVector.zeros(Math.multiplyExact(rows, width));
        IntStream.range(0, (rows + 1) / 2).parallel().forEach(pair -> transformPair(source, 2 * pair, half));
        int count = alongX.band().count();
        double[] powers = new double[Math.multiplyExact(count, alongY.band().count())];
        forEachColumn(half, width, (column, work) -> {
            ComplexVector bins = ComplexVector.zeros(alongY.band().count());
            alongY.transform(work, bins, 0, 1);
            for (int i = 0; i < bins.length(); i++) {
                double square = bins.real()[i] * bins.real()[i] + bins.imaginary()[i] * bins.imaginary()[i];
                powers[(bins.length() - 1 - i) * count + reachX + column] = square;
                powers[i * count + reachX - column] = square;
            }
        });
        return powers;
    }

    private void transformPair(RealRowSource source, int row, ComplexVector half) {
        ComplexVector work = alongX.workspace();
        source.fill(row, work.real());
        boolean two = row + 1 < rows;
        if (two) {
            source.fill(row + 1, work.imaginary());
        }
        int reachX = alongX.band().last();
        ComplexVector bins = ComplexVector.zeros(2 * reachX + 1);
        alongX.transform(work, bins, 0, 1);
        for (int jx = 0, at = row * (reachX + 1); jx <= reachX; jx++, at++) {
            double real = bins.real()[reachX + jx];
            double imaginary = bins.imaginary()[reachX + jx];
            double mirroredReal = bins.real()[reachX - jx];
            double mirroredImaginary = bins.imaginary()[reachX - jx];
            half.real()[at] = 0.5 * (real + mirroredReal);
            half.imaginary()[at] = 0.5 * (imaginary - mirroredImaginary);
            if (two) {
                half.real()[at + reachX + 1] = 0.5 * (imaginary + mirroredImaginary);
                half.imaginary()[at + reachX + 1] = 0.5 * (mirroredReal - real);
            }
        }
    }
}
