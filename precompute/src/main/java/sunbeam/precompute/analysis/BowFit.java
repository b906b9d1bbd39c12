package sunbeam.precompute.analysis;

import java.util.Arrays;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * Least squares of a surface of second degree together with a wave and its first overtones. All terms are products of one
 * of x and one of y, so that sums of their products over the grid are products of sums along the axes, and the heights are
 * looked at once.
 */
final class BowFit {
    /** Of the surface: 1, x, y, x^2, x y, y^2. */
    static final int TERMS = 6;

    private static final int[] POWERS_X = {0, 1, 0, 2, 1, 0};
    private static final int[] POWERS_Y = {0, 0, 1, 0, 1, 2};
    private static final int DEGREE = 2;
    // The wave and its first overtones, which a sawtooth has, too.
    private static final int OVERTONES = 3;

    private final AxisWaves x;
    private final AxisWaves y;

    /**
     * @param x columns, with the wave along x
     * @param y rows, with the wave along y
     */
    BowFit(AxisWaves x, AxisWaves y) {
        this.x = x;
        this.y = y;
    }

    /**
     * Positions along an axis, and a wave along it.
     *
     * @param places in units of the whole extent, the middle at 0
     * @param cosines of the wave's phases
     * @param sines of the wave's phases
     */
    record AxisWaves(double[] places, double[] cosines, double[] sines) {
        /** Sum of place^power exp(i multiple phase), real and imaginary part. */
        private double[] sum(int power, int multiple) {
            double[] sum = new double[2];
            double[] wave = new double[2];
            for (int i = 0; i < places.length; i++) {
                double factor = Math.pow(places[i], power);
                wave(i, multiple, wave);
                sum[0] += factor * wave[0];
                sum[1] += factor * wave[1];
            }
            return sum;
        }

        /** exp(i multiple phase) of a place. */
        private void wave(int place, int multiple, double[] wave) {
            wave[0] = 1;
            wave[1] = 0;
            for (int m = 0; m < multiple; m++) {
                double real = wave[0] * cosines[place] - wave[1] * sines[place];
                wave[1] = wave[0] * sines[place] + wave[1] * cosines[place];
                wave[0] = real;
            }
        }
    }

    /**
     * The surface's coefficients; the pseudo-inverse bears single rows and columns.
     *
     * @param heights row by row
     */
    double[] coefficients(double[] heights) {
        double[] fitted = new SingularValueDecomposition(new Array2DRowRealMatrix(normal()))
                .getSolver()
                .solve(new ArrayRealVector(right(heights)))
                .toArray();
        return Arrays.copyOf(fitted, TERMS);
    }

    /** The surface's value at a place. */
    static double surface(double[] coefficients, double x, double y) {
        return coefficients[0]
                + x * (coefficients[1] + x * coefficients[3] + y * coefficients[4])
                + y * (coefficients[2] + y * coefficients[5]);
    }

    private double[][] normal() {
        double[][] normal = new double[TERMS + 2 * OVERTONES][TERMS + 2 * OVERTONES];
        for (int i = 0; i < TERMS; i++) {
            for (int j = 0; j < TERMS; j++) {
                normal[i][j] = sum(POWERS_X[i] + POWERS_X[j], POWERS_Y[i] + POWERS_Y[j], 0)[0];
            }
            for (int m = 1; m <= OVERTONES; m++) {
                double[] product = sum(POWERS_X[i], POWERS_Y[i], m);
                for (int part = 0; part < 2; part++) {
                    normal[i][wave(m) + part] = product[part];
                    normal[wave(m) + part][i] = product[part];
                }
            }
        }
        for (int m = 1; m <= OVERTONES; m++) {
            for (int n = 1; n <= OVERTONES; n++) {
                double[] together = sum(0, 0, m + n);
                double[] apart = sum(0, 0, Math.abs(m - n));
                double signed = m < n ? -apart[1] : apart[1];
                normal[wave(m)][wave(n)] = 0.5 * (apart[0] + together[0]);
                normal[wave(m) + 1][wave(n) + 1] = 0.5 * (apart[0] - together[0]);
                normal[wave(m) + 1][wave(n)] = 0.5 * (together[1] + signed);
                normal[wave(n)][wave(m) + 1] = normal[wave(m) + 1][wave(n)];
            }
        }
        return normal;
    }

    private static int wave(int multiple) {
        return TERMS + 2 * (multiple - 1);
    }

    /** Over the grid, of x^powerX y^powerY exp(i multiple phase). */
    private double[] sum(int powerX, int powerY, int multiple) {
        double[] alongX = x.sum(powerX, multiple);
        double[] alongY = y.sum(powerY, multiple);
        return new double[] {
            alongX[0] * alongY[0] - alongX[1] * alongY[1], alongX[0] * alongY[1] + alongX[1] * alongY[0]
        };
    }

    private double[] right(double[] heights) {
        int columns = x.places().length;
        double[][][] waves = new double[OVERTONES + 1][columns][2];
        for (int m = 1; m <= OVERTONES; m++) {
            for (int column = 0; column < columns; column++) {
                x.wave(column, m, waves[m][column]);
            }
        }
        double[] right = new double[TERMS + 2 * OVERTONES];
        double[] wave = new double[2];
        for (int row = 0; row < y.places().length; row++) {
            double[] powers = powerSums(heights, row * columns);
            for (int i = 0; i < TERMS; i++) {
                right[i] += powers[POWERS_X[i]] * Math.pow(y.places()[row], POWERS_Y[i]);
            }
            for (int m = 1; m <= OVERTONES; m++) {
                double[] sum = waveSum(heights, row * columns, waves[m]);
                y.wave(row, m, wave);
                right[wave(m)] += sum[0] * wave[0] - sum[1] * wave[1];
                right[wave(m) + 1] += sum[0] * wave[1] + sum[1] * wave[0];
            }
        }
        return right;
    }

    private double[] powerSums(double[] heights, int first) {
        double[] sums = new double[DEGREE + 1];
        for (int column = 0; column < x.places().length; column++) {
            double place = x.places()[column];
            double height = heights[first + column];
            sums[0] += height;
            sums[1] += height * place;
            sums[2] += height * place * place;
        }
        return sums;
    }

    private static double[] waveSum(double[] heights, int first, double[][] wave) {
        double real = 0;
        double imaginary = 0;
        for (int column = 0; column < wave.length; column++) {
            real += heights[first + column] * wave[column][0];
            imaginary += heights[first + column] * wave[column][1];
        }
        return new double[] {real, imaginary};
    }
}
