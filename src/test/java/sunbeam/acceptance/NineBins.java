package sunbeam.acceptance;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;

/**
 * The thesis's neighborhood by its definition: nine DFT bins of exp(i k w h) around the bin at or below the frequency, times the window's
 * spectrum or a sinc, added, squared. No expansion, double precision.
 */
final class NineBins {
    private static final double SIGMA_FREQUENCY = 1 / (2 * Math.PI * 65e-6 / 4);

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
        double sigma = SIGMA_FREQUENCY * width;
        double high = (double) rows / columns;
        return power(
                u, v, w, wavelength, 0.5, (x, y) -> Math.exp(-(x * x + y * y / (high * high)) / (2 * sigma * sigma)));
    }

    /** Returns the power of the patch alone by the thesis's sinc of the bins' distance, with phases from the patch's corner. */
    double ring(double u, double v, double w, double wavelength) {
        return power(u, v, w, wavelength, 0, (x, y) -> {
            double angle = Math.PI * Math.max(1e-9, Math.hypot(x, y));
            return Math.sin(angle) / angle;
        });
    }

    private double power(double u, double v, double w, double wavelength, double origin, Weight weight) {
        double pitch = width / columns;
        double height = rows * pitch;
        int firstX = (int) Math.floor(u / wavelength * width) - 1;
        int firstY = (int) Math.floor(v / wavelength * height) - 1;
        double[] sum = new double[2];
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < 3; i++) {
                double share = weight.at(u / wavelength * width - firstX - i, v / wavelength * height - firstY - j);
                double[] bin = bin(firstX + i, firstY + j, 2 * Math.PI / wavelength * w, origin);
                sum[0] += share * bin[0];
                sum[1] += share * bin[1];
            }
        }
        return sum[0] * sum[0] + sum[1] * sum[1];
    }

    /** Returns (1/N) sum exp(i kw h) exp(2 pi i (jx x - jy row)); x and row count from a share of the sides. */
    private double[] bin(int jx, int jy, double kw, double origin) {
        double[] levels = new double[512];
        for (int level = 0; level < 256; level++) {
            levels[2 * level] = Math.cos(kw * level * metersPerStep);
            levels[2 * level + 1] = Math.sin(kw * level * metersPerStep);
        }
        double[] turnX = turns(jx, columns, (int) (origin * columns));
        double[] turnY = turns(-jy, rows, (int) (origin * rows));
        double[][] ofRows = IntStream.range(0, rows)
                .parallel()
                .mapToObj(row -> {
                    double real = 0;
                    double imaginary = 0;
                    for (int column = 0; column < columns; column++) {
                        double a = levels[2 * samples[row * columns + column]];
                        double b = levels[2 * samples[row * columns + column] + 1];
                        real += a * turnX[2 * column] - b * turnX[2 * column + 1];
                        imaginary += a * turnX[2 * column + 1] + b * turnX[2 * column];
                    }
                    return new double[] {
                        real * turnY[2 * row] - imaginary * turnY[2 * row + 1],
                        real * turnY[2 * row + 1] + imaginary * turnY[2 * row]
                    };
                })
                .toArray(double[][]::new);
        double[] sum = new double[2];
        for (double[] row : ofRows) {
            sum[0] += row[0] / ((double) rows * columns);
            sum[1] += row[1] / ((double) rows * columns);
        }
        return sum;
    }

    /** Returns exp(2 pi i bin (sample - origin) / count), real and imaginary parts interleaved. */
    private static double[] turns(int bin, int count, int origin) {
        double[] result = new double[2 * count];
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * Math.floorMod((long) bin * (i - origin), (long) count) / count;
            result[2 * i] = Math.cos(angle);
            result[2 * i + 1] = Math.sin(angle);
        }
        return result;
    }
}
