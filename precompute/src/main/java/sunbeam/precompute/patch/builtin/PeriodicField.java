package sunbeam.precompute.patch.builtin;

import java.util.stream.IntStream;

/**
 * A smooth random field that repeats with the grid: a sum of plane waves with whole numbers of periods (p, q) across
 * the two sides, with random phases and a power spectral density that falls as a power of sqrt(p^2 + q^2) and ends at
 * an ellipse. Its mean is 0 and its root mean square over the grid is the one asked for.
 */
final class PeriodicField {
    private final int columns;
    private final int rows;
    private final double exponent;
    private final int modesX;
    private final int modesY;
    private final SeededNoise noise;

    private PeriodicField(int columns, int rows, double exponent, int modesX, int modesY, SeededNoise noise) {
        this.columns = columns;
        this.rows = rows;
        this.exponent = exponent;
        this.modesX = modesX;
        this.modesY = modesY;
        this.noise = noise;
    }

    /**
     * Draws a field.
     *
     * @param columns samples along the first axis
     * @param rows samples along the second axis
     * @param rms root mean square of the field, in the unit that the field shall have
     * @param exponent the density falls as frequency to minus this power
     * @param modesX most periods along the first axis, at least 1 and below {@code columns / 2}
     * @param modesY most periods along the second axis, at least 1 and below {@code rows / 2}
     * @return {@code rows * columns} values, row by row
     */
    static double[] powerLaw(
            int columns, int rows, double rms, double exponent, int modesX, int modesY, SeededNoise noise) {
        if (modesX < 1 || 2 * modesX >= columns || modesY < 1 || 2 * modesY >= rows) {
            throw new IllegalArgumentException(
                    modesX + " x " + modesY + " periods do not fit into " + columns + " x " + rows + " samples");
        }
        return scaledToRms(new PeriodicField(columns, rows, exponent, modesX, modesY, noise).sum(), rms);
    }

    /** Sums over p once for each q, so that the cost is rows * columns * modesY, not times the number of waves. */
    private double[] sum() {
        double[][] real = new double[modesY + 1][columns];
        double[][] imaginary = new double[modesY + 1][columns];
        for (int q = 0; q <= modesY; q++) {
            sumOverP(q, real[q], imaginary[q]);
        }
        double[][] circle = circle(rows);
        double[] field = new double[rows * columns];
        IntStream.range(0, rows).parallel().forEach(row -> {
            double[] sum = new double[columns];
            for (int q = 0; q <= modesY; q++) {
                double cos = circle[0][q * row % rows];
                double sin = circle[1][q * row % rows];
                double[] realOfQ = real[q];
                double[] imaginaryOfQ = imaginary[q];
                for (int column = 0; column < columns; column++) {
                    sum[column] += realOfQ[column] * cos - imaginaryOfQ[column] * sin;
                }
            }
            System.arraycopy(sum, 0, field, row * columns, columns);
        });
        return field;
    }

    private void sumOverP(int q, double[] real, double[] imaginary) {
        double[][] circle = circle(columns);
        // Of each wave and its mirror image (-p, -q) only one is needed, and (0, 0) would shift the mean.
        for (int p = q == 0 ? 1 : -modesX; p <= modesX; p++) {
            if (StrictMath.hypot((double) p / modesX, (double) q / modesY) > 1) {
                continue;
            }
            double amplitude = StrictMath.pow(StrictMath.hypot(p, q), -exponent / 2);
            double re = amplitude * noise.normal();
            double im = amplitude * noise.normal();
            for (int column = 0; column < columns; column++) {
                double cos = circle[0][Math.floorMod(p * column, columns)];
                double sin = circle[1][Math.floorMod(p * column, columns)];
                real[column] += re * cos - im * sin;
                imaginary[column] += re * sin + im * cos;
            }
        }
    }

    /** Cosines and sines of {@code count} equal steps round the circle. */
    private static double[][] circle(int count) {
        double[][] circle = new double[2][count];
        for (int i = 0; i < count; i++) {
            circle[0][i] = StrictMath.cos(2 * StrictMath.PI * i / count);
            circle[1][i] = StrictMath.sin(2 * StrictMath.PI * i / count);
        }
        return circle;
    }

    private static double[] scaledToRms(double[] field, double rms) {
        double squares = 0;
        for (double value : field) {
            squares += value * value;
        }
        double factor = rms / StrictMath.sqrt(squares / field.length);
        for (int i = 0; i < field.length; i++) {
            field[i] *= factor;
        }
        return field;
    }
}
