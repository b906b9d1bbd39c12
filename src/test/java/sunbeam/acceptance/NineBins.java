package sunbeam.acceptance;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.jtransforms.fft.DoubleFFT_2D;

/**
 * The thesis's neighborhood by its definition: nine DFT bins of exp(i k w h) around the bin at or below the frequency, times the window's
 * spectrum or a sinc, added, squared. No expansion, double precision.
 */
final class NineBins {
    private final int columns;
    private final int rows;
    /** Samples row by row, from the top. */
    private final int[] samples;

    private final double metersPerStep;
    private final double width;

    /** @param fullScale height of the value 255, meters */
    NineBins(Path image, double width, double fullScale) throws IOException {
        Raster raster = ImageIO.read(image.toFile()).getRaster();
        this.columns = raster.getWidth();
        this.rows = raster.getHeight();
        this.samples = raster.getSamples(0, 0, columns, rows, 0, (int[]) null);
        this.width = width;
        this.metersPerStep = fullScale / 255;
    }

    /** Weight of a bin at a distance in bins along x and y. */
    private interface Weight {
        double at(double x, double y);
    }

    /** Returns the coherent power with the window on the patch's center. */
    double power(double u, double v, double w, double wavelength) {
        double sigma = width / (2 * Math.PI * 65e-6 / 4);
        double high = (double) rows / columns;
        return power(
                u, v, w, wavelength, true, (x, y) -> Math.exp(-(x * x + y * y / (high * high)) / (2 * sigma * sigma)));
    }

    /** Returns the power of the patch alone by the thesis's sinc of the bins' distance, with phases from the patch's corner. */
    double ring(double u, double v, double w, double wavelength) {
        return power(u, v, w, wavelength, false, (x, y) -> {
            double angle = Math.PI * Math.max(1e-9, Math.hypot(x, y));
            return Math.sin(angle) / angle;
        });
    }

    /** @param signed whether phases are counted from the center, half a side away, else from the corner */
    private double power(double u, double v, double w, double wavelength, boolean signed, Weight weight) {
        double height = rows * width / columns;
        double[] bins = bins(2 * Math.PI / wavelength * w);
        int firstX = (int) Math.floor(u / wavelength * width) - 1;
        int firstY = (int) Math.floor(v / wavelength * height) - 1;
        double real = 0;
        double imaginary = 0;
        for (int y = firstY; y < firstY + 3; y++) {
            for (int x = firstX; x < firstX + 3; x++) {
                double share = weight.at(u / wavelength * width - x, v / wavelength * height - y);
                double sign = signed && (x + y) % 2 != 0 ? -1 : 1;
                int bin = 2 * (Math.floorMod(-y, rows) * columns + Math.floorMod(x, columns));
                real += share * sign * bins[bin];
                imaginary += share * sign * bins[bin + 1];
            }
        }
        return real * real + imaginary * imaginary;
    }

    /** Returns (1/N) sum exp(i kw h) exp(2 pi i (jx x - jy row)) of all bins, rows of negative jy, by JTransforms. */
    private double[] bins(double kw) {
        double[] field = new double[2 * samples.length];
        for (int i = 0; i < samples.length; i++) {
            field[2 * i] = Math.cos(kw * samples[i] * metersPerStep);
            field[2 * i + 1] = Math.sin(kw * samples[i] * metersPerStep);
        }
        new DoubleFFT_2D(rows, columns).complexInverse(field, true);
        return field;
    }
}
