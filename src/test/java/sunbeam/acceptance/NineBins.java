package sunbeam.acceptance;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;

/**
 * What the thesis's neighborhood makes of a measured patch, by the definition: nine DFT bins of exp(i k w h), the one at
 * or below the frequency in their middle, times the window's spectrum, added, squared. No expansion, double precision.
 */
final class NineBins {
    private static final double SIGMA_FREQUENCY = 1 / (2 * Math.PI * 65e-6 / 4);

    private final int columns;
    private final int rows;
    /** Row by row, the first at the top. */
    private final int[] samples;

    private final double metresPerStep;
    private final double width;

    /** @param fullScale height of the value 255, metres */
    NineBins(Path image, double width, double fullScale) throws IOException {
        Raster raster = ImageIO.read(image.toFile()).getRaster();
        this.columns = raster.getWidth();
        this.rows = raster.getHeight();
        this.samples = raster.getSamples(0, 0, columns, rows, 0, (int[]) null);
        this.width = width;
        this.metresPerStep = fullScale / 255;
    }

    /** Coherent power with the window on the patch's centre. */
    double power(double u, double v, double w, double wavelength) {
        double pitch = width / columns;
        double height = rows * pitch;
        int firstX = (int) Math.floor(u / wavelength * width) - 1;
        int firstY = (int) Math.floor(v / wavelength * height) - 1;
        double[] sum = new double[2];
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < 3; i++) {
                double offX = u / wavelength - (firstX + i) / width;
                double offY = v / wavelength - (firstY + j) / height;
                double gauss = Math.exp(-(offX * offX + offY * offY) / (2 * SIGMA_FREQUENCY * SIGMA_FREQUENCY));
                double[] bin = bin(firstX + i, firstY + j, 2 * Math.PI / wavelength * w);
                sum[0] += gauss * bin[0];
                sum[1] += gauss * bin[1];
            }
        }
        return sum[0] * sum[0] + sum[1] * sum[1];
    }

    /** (1/N) sum exp(i kw h) exp(2 pi i (jx x - jy row)), x and row counted from the centre. */
    private double[] bin(int jx, int jy, double kw) {
        double[] levels = new double[512];
        for (int level = 0; level < 256; level++) {
            levels[2 * level] = Math.cos(kw * level * metresPerStep);
            levels[2 * level + 1] = Math.sin(kw * level * metresPerStep);
        }
        double[] turnX = turns(jx, columns);
        double[] turnY = turns(-jy, rows);
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

    /** exp(2 pi i bin (sample - centre) / count), real and imaginary parts interleaved. */
    private static double[] turns(int bin, int count) {
        double[] result = new double[2 * count];
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * Math.floorMod((long) bin * (i - count / 2), (long) count) / count;
            result[2 * i] = Math.cos(angle);
            result[2 * i + 1] = Math.sin(angle);
        }
        return result;
    }
}
