package sunbeam.precompute.fourier;

import java.util.stream.IntStream;

/**
 * Squared magnitudes of the bins around 0 of a real field's two-dimensional DFT, as defined by {@link BandTransform2d}. Bins (jx, jy) and
 * (-jx, -jy) are complex conjugates: two rows are transformed as one complex row, and only columns with jx >= 0. Runs on all cores.
 */
public final class PowerSpectrum2d {
    private final int rows;
    private final int reachX;
    private final int reachY;
    private final BandTransform alongX;
    private final BandTransform alongY;

    /** Source of the field's samples. Must be thread-safe. */
    @FunctionalInterface
    public interface RowSource {
        void fill(int row, double[] samples);
    }

    /** @param reachX last bin along x (the first one is -reachX); less than half the number of columns */
    public PowerSpectrum2d(int columns, int rows, int reachX, int reachY) {
        this.rows = rows;
        this.reachX = reachX;
        this.reachY = reachY;
        this.alongX = new BandTransform(columns, Band.of(-reachX, reachX));
        this.alongY = new BandTransform(rows, Band.of(-reachY, reachY));
    }

    /** Returns the power of bin (jx, jy) at index {@code (jy + reachY) (2 reachX + 1) + jx + reachX}; jy grows with y. */
    public double[] power(RowSource source) {
        int width = reachX + 1;
        ComplexVector half = ComplexVector.zeros(Math.multiplyExact(rows, width));
        IntStream.range(0, (rows + 1) / 2).parallel().forEach(pair -> transformPair(source, 2 * pair, half));
        double[] power = new double[Math.multiplyExact(2 * reachX + 1, 2 * reachY + 1)];
        IntStream.range(0, width).parallel().forEach(column -> {
            ComplexVector work = alongY.workspace();
            for (int row = 0; row < rows; row++) {
                work.real()[row] = half.real()[row * width + column];
                work.imaginary()[row] = half.imaginary()[row * width + column];
            }
            ComplexVector bins = ComplexVector.zeros(2 * reachY + 1);
            alongY.transform(work, bins, 0, 1);
            for (int i = 0; i < bins.length(); i++) {
                double square = bins.real()[i] * bins.real()[i] + bins.imaginary()[i] * bins.imaginary()[i];
                // Rows run downwards: bin jy of y is bin -jy of the row index.
                int jy = reachY - i;
                power[place(column, jy)] = square;
                power[place(-column, -jy)] = square;
            }
        });
        return power;
    }

    private int place(int jx, int jy) {
        return (jy + reachY) * (2 * reachX + 1) + jx + reachX;
    }

    private void transformPair(RowSource source, int row, ComplexVector half) {
        ComplexVector work = alongX.workspace();
        source.fill(row, work.real());
        boolean two = row + 1 < rows;
        if (two) {
            source.fill(row + 1, work.imaginary());
        }
        ComplexVector bins = ComplexVector.zeros(2 * reachX + 1);
        alongX.transform(work, bins, 0, 1);
        int width = reachX + 1;
        for (int jx = 0; jx <= reachX; jx++) {
            double real = bins.real()[reachX + jx];
            double imaginary = bins.imaginary()[reachX + jx];
            double mirroredReal = bins.real()[reachX - jx];
            double mirroredImaginary = bins.imaginary()[reachX - jx];
            half.real()[row * width + jx] = 0.5 * (real + mirroredReal);
            half.imaginary()[row * width + jx] = 0.5 * (imaginary - mirroredImaginary);
            if (two) {
                half.real()[(row + 1) * width + jx] = 0.5 * (imaginary + mirroredImaginary);
                half.imaginary()[(row + 1) * width + jx] = 0.5 * (mirroredReal - real);
            }
        }
    }
}
