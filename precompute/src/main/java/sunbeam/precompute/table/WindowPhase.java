package sunbeam.precompute.table;

import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Moves the origin of a table's phases from the top left sample to the sample under the window's maximum, and multiplies each term by its
 * factor {@link sunbeam.precompute.expansion.ExpansionKind#turn}.
 */
public final class WindowPhase {
    private final FourierTable table;
    private final double[][] alongX;
    private final double[][] alongY;

    public WindowPhase(FourierTable table, WindowOrigin origin) {
        this.table = table;
        int columns = table.patch().columns();
        int rows = table.patch().rows();
        alongX = table.bandX().phases(columns, -origin.sample(columns));
        // Rows run downwards, y upwards.
        alongY = table.bandY().phases(rows, origin.sample(rows));
    }

    /** Returns one term with the new origin and its factor, in the table's order of bins. */
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
