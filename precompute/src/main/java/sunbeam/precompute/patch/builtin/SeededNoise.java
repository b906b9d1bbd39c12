package sunbeam.precompute.patch.builtin;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Reproducible random numbers and fields. Normal deviates are those of Box and Muller (Ann. Math. Statist. 29, 1958) with {@link
 * StrictMath}; the JDK does not specify {@code nextGaussian}.
 */
final class SeededNoise {
    private final SplittableRandom random;

    SeededNoise(long seed) {
        random = new SplittableRandom(seed);
    }

    /** In [0, 1). */
    double uniform() {
        return random.nextDouble();
    }

    double normal() {
        double radius = StrictMath.sqrt(-2 * StrictMath.log(1 - random.nextDouble()));
        return radius * StrictMath.cos(2 * StrictMath.PI * random.nextDouble());
    }

    /**
     * Generates a smooth, periodic field, row by row, of mean 0: a sum of plane waves with integer numbers of periods along the sides and
     * random phases, whose power spectral density falls as frequency to minus {@code exponent} within an ellipse.
     *
     * @param modesX most periods along the first axis, below {@code columns / 2}
     */
    double[] powerLaw(int columns, int rows, double rms, double exponent, int modesX, int modesY) {
        double[][] real = new double[modesY + 1][columns];
        double[][] imaginary = new double[modesY + 1][columns];
        double[][] circle = circle(columns);
        for (int q = 0; q <= modesY; q++) {
            // Without conjugate waves (-p, -q) and (0, 0), which would shift the mean.
            for (int p = q == 0 ? 1 : -modesX; p <= modesX; p++) {
                if (StrictMath.hypot((double) p / modesX, (double) q / modesY) > 1) {
                    continue;
                }
                double amplitude = StrictMath.pow(StrictMath.hypot(p, q), -exponent / 2);
                double re = amplitude * normal();
                double im = amplitude * normal();
                for (int column = 0; column < columns; column++) {
                    double cos = circle[0][Math.floorMod(p * column, columns)];
                    double sin = circle[1][Math.floorMod(p * column, columns)];
                    real[q][column] += re * cos - im * sin;
                    imaginary[q][column] += re * sin + im * cos;
                }
            }
        }
        double[] field = sumOverRows(real, imaginary, rows);
        double factor = rms / StrictMath.sqrt(StatUtils.sumSq(field) / field.length);
        Arrays.setAll(field, i -> factor * field[i]);
        return field;
    }

    private static double[] sumOverRows(double[][] real, double[][] imaginary, int rows) {
        int columns = real[0].length;
        double[][] circle = circle(rows);
        double[] field = new double[rows * columns];
        IntStream.range(0, rows).parallel().forEach(row -> {
            double[] sum = new double[columns];
            for (int q = 0; q < real.length; q++) {
                double cos = circle[0][q * row % rows];
                double sin = circle[1][q * row % rows];
                for (int column = 0; column < columns; column++) {
                    sum[column] += real[q][column] * cos - imaginary[q][column] * sin;
                }
            }
            System.arraycopy(sum, 0, field, row * columns, columns);
        });
        return field;
    }

    private static double[][] circle(int count) {
        double[][] circle = new double[2][count];
        for (int i = 0; i < count; i++) {
            circle[0][i] = StrictMath.cos(2 * StrictMath.PI * i / count);
            circle[1][i] = StrictMath.sin(2 * StrictMath.PI * i / count);
        }
        return circle;
    }

    /** White noise of standard deviation 1, smoothed with a Gaussian of sigma samples. */
    double[] grain(int samples, double sigma) {
        double[] grains = new double[samples * samples];
        Arrays.setAll(grains, i -> normal());
        // Half of a Gaussian from its center with a sum of squares of 1, so that noise keeps its variance.
        double[] kernel = new double[1 + (int) Math.ceil(3 * sigma)];
        Arrays.setAll(kernel, i -> StrictMath.exp(-i * i / (2 * sigma * sigma)));
        double squares = kernel[0] * kernel[0];
        for (int i = 1; i < kernel.length; i++) {
            squares += 2 * kernel[i] * kernel[i];
        }
        double norm = StrictMath.sqrt(squares);
        Arrays.setAll(kernel, i -> kernel[i] / norm);
        return smoothed(smoothed(grains, kernel, samples, 1, samples), kernel, samples, samples, 1);
    }

    /** Convolves all lines along one axis with a symmetric kernel, given from its center on, periodically. */
    private static double[] smoothed(double[] values, double[] kernel, int size, int step, int lineStep) {
        int reach = kernel.length - 1;
        double[] result = new double[values.length];
        IntStream.range(0, size).parallel().forEach(line -> {
            double[] wrapped = new double[size + 2 * reach];
            Arrays.setAll(wrapped, i -> values[line * lineStep + Math.floorMod(i - reach, size) * step]);
            for (int i = 0; i < size; i++) {
                int middle = i + reach;
                double sum = kernel[0] * wrapped[middle];
                for (int k = 1; k <= reach; k++) {
                    sum += kernel[k] * (wrapped[middle - k] + wrapped[middle + k]);
                }
                result[line * lineStep + i * step] = sum;
            }
        });
        return result;
    }
}
