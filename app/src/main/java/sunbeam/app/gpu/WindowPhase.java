package sunbeam.app.gpu;

import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.table.FourierTable;

/**
 * Moves the origin of a table's phases from the top left sample to the one under the window's maximum, and turns each
 * term by its constant factor.
 */
final class WindowPhase {
    private final FourierTable table;
    private final double[][] alongX;
    private final double[][] alongY;

    WindowPhase(FourierTable table, WindowOrigin origin) {
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

    /** One term with the moved origin, real and imaginary parts interleaved. */
    float[] interleaved(int term) {
        int columns = table.bandX().count();
        Complex turn = table.kind().turn(term);
        float[] result = new float[2 * columns * table.bandY().count()];
        for (int i = 0; i < result.length / 2; i++) {
            int column = i % columns;
            int row = i / columns;
            double cosine = alongX[0][column] * alongY[0][row] - alongX[1][column] * alongY[1][row];
            double sine = alongX[0][column] * alongY[1][row] + alongX[1][column] * alongY[0][row];
            double a = table.real()[term][i];
            double b = table.imaginary()[term][i];
            double real = a * turn.getReal() - b * turn.getImaginary();
            double imaginary = a * turn.getImaginary() + b * turn.getReal();
            result[2 * i] = (float) (real * cosine - imaginary * sine);
            result[2 * i + 1] = (float) (real * sine + imaginary * cosine);
        }
        return result;
    }
}
