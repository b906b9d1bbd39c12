package sunbeam.precompute.table;

import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Moves the origin of a table's phases from the top left sample to the one under the window's maximum, and turns each
 * term by its constant factor.
 */
public final class WindowPhase {
    private final FourierTable table;
    private final double[][] alongX;
    private final double[][] alongY;

    public WindowPhase(FourierTable table, WindowOrigin origin) {
        this.table = table;
        int columns = table.patch().columns();
        int rows = table.patch().rows();
        alongX = phases(table.bandX(), columns, -origin.sample(columns));
        // Rows run downwards, y upwards.
        alongY = phases(table.bandY(), rows, origin.sample(rows));
    }

    /** exp(2 pi i bin shift / samples) for each bin: cosines, sines. */
    private static double[][] phases(Band band, int samples, int shift) {
        double[][] result = new double[2][band.count()];
        for (int i = 0; i < band.count(); i++) {
            long turns = Math.floorMod((long) (band.first() + i) * shift, (long) samples);
            double angle = 2 * Math.PI * turns / samples;
            result[0][i] = Math.cos(angle);
            result[1][i] = Math.sin(angle);
        }
        return result;
    }

    /** One term with the moved origin, in the table's order of bins. */
    public ComplexVector term(int n) {
        int columns = table.bandX().count();
        int bins = columns * table.bandY().count();
        Complex turn = table.kind().turn(n);
        ComplexVector result = ComplexVector.zeros(bins);
        for (int i = 0; i < bins; i++) {
            int column = i % columns;
            int row = i / columns;
            double cosine = alongX[0][column] * alongY[0][row] - alongX[1][column] * alongY[1][row];
            double sine = alongX[0][column] * alongY[1][row] + alongX[1][column] * alongY[0][row];
            double a = table.real()[n][i];
            double b = table.imaginary()[n][i];
            double real = a * turn.getReal() - b * turn.getImaginary();
            double imaginary = a * turn.getImaginary() + b * turn.getReal();
            result.real()[i] = real * cosine - imaginary * sine;
            result.imaginary()[i] = real * sine + imaginary * cosine;
        }
        return result;
    }
}
