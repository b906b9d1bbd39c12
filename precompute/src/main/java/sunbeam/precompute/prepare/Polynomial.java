package sunbeam.precompute.prepare;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * The least-squares polynomial through heights, of first or second degree in x and y, over coordinates from -1 to 1;
 * where samples lie on one line, the pseudo-inverse takes the slope along it. Missing
 * samples take no part.
 */
final class Polynomial {
    // Of 1, x, y, x^2, x y, y^2.
    private static final int[] POWERS_OF_X = {0, 1, 0, 2, 1, 0};
    private static final int[] POWERS_OF_Y = {0, 0, 1, 0, 1, 2};
    private static final int HIGHEST = 2;

    private final HeightField field;
    private final double offset;
    private final RealVector coefficients;

    private Polynomial(HeightField field, double offset, RealVector coefficients) {
        this.field = field;
        this.offset = offset;
        this.coefficients = coefficients;
    }

    /**
     * Fits.
     *
     * @param terms 1 for the mean, 3 for a plane, 6 for a quadratic surface
     */
    static Polynomial fit(HeightField field, int terms) {
        // Relative to one of them, so that a large common offset costs no digits.
        double offset = Arrays.stream(field.heights())
                .filter(Double::isFinite)
                .findFirst()
                .orElse(0);
        double[][] normal = new double[terms][terms];
        double[] right = new double[terms];
        for (Moments row : moments(field, offset)) {
            for (int j = 0; j < terms; j++) {
                right[j] += row.heights[POWERS_OF_X[j]] * Math.pow(row.y, POWERS_OF_Y[j]);
                for (int k = 0; k < terms; k++) {
                    normal[j][k] += row.places[POWERS_OF_X[j] + POWERS_OF_X[k]]
                            * Math.pow(row.y, (double) POWERS_OF_Y[j] + POWERS_OF_Y[k]);
                }
            }
        }
        RealVector fitted = new SingularValueDecomposition(new Array2DRowRealMatrix(normal))
                .getSolver()
                .solve(new ArrayRealVector(right));
        return new Polynomial(field, offset, fitted);
    }

    /**
     * Sums over a row's samples that are there.
     *
     * @param y of the row
     * @param places of the powers of x from 0 on
     * @param heights of the heights times the powers of x from 0 on
     */
    private record Moments(double y, double[] places, double[] heights) {
        static Moments of(HeightField field, int row, double offset) {
            double[] places = new double[2 * HIGHEST + 1];
            double[] heights = new double[HIGHEST + 1];
            for (int column = 0; column < field.columns(); column++) {
                double height = field.at(column, row);
                if (Double.isFinite(height)) {
                    double x = field.relativeX(column);
                    double square = x * x;
                    places[0]++;
                    places[1] += x;
                    places[2] += square;
                    places[3] += square * x;
                    places[4] += square * square;
                    heights[0] += height - offset;
                    heights[1] += (height - offset) * x;
                    heights[2] += (height - offset) * square;
                }
            }
            return new Moments(field.relativeY(row), places, heights);
        }
    }

    /** Of all rows, in their order. */
    private static List<Moments> moments(HeightField field, double offset) {
        return IntStream.range(0, field.rows())
                .parallel()
                .mapToObj(row -> Moments.of(field, row, offset))
                .toList();
    }

    /** Mean square of the heights less the polynomial; 0 where none is there. */
    double variance() {
        double[] sums = new double[2];
        IntStream.range(0, field.rows())
                .parallel()
                .mapToObj(this::squares)
                .toList()
                .forEach(row -> {
                    sums[0] += row[0];
                    sums[1] += row[1];
                });
        return sums[1] == 0 ? 0 : sums[0] / sums[1];
    }

    /** Sum over a row, and of how many samples. */
    private double[] squares(int row) {
        double[] ofX = ofX(row);
        double sum = 0;
        int count = 0;
        for (int column = 0; column < field.columns(); column++) {
            double height = field.at(column, row);
            if (Double.isFinite(height)) {
                double x = field.relativeX(column);
                double rest = height - offset - (ofX[0] + x * (ofX[1] + x * ofX[2]));
                sum += rest * rest;
                count++;
            }
        }
        return new double[] {sum, count};
    }

    /** The polynomial along a row: coefficients of the powers of x. */
    private double[] ofX(int row) {
        double y = field.relativeY(row);
        double[] ofX = new double[HIGHEST + 1];
        for (int j = 0; j < coefficients.getDimension(); j++) {
            ofX[POWERS_OF_X[j]] += coefficients.getEntry(j) * Math.pow(y, POWERS_OF_Y[j]);
        }
        return ofX;
    }

    /** The heights less the polynomial. */
    HeightField subtracted() {
        double[] heights = field.heights().clone();
        IntStream.range(0, field.rows()).parallel().forEach(row -> {
            double[] ofX = ofX(row);
            for (int column = 0, i = row * field.columns(); column < field.columns(); column++, i++) {
                double x = field.relativeX(column);
                heights[i] = heights[i] - offset - (ofX[0] + x * (ofX[1] + x * ofX[2]));
            }
        });
        return field.with(heights);
    }

    /** Of a plane: how much it rises from the left border to the right one, metres. */
    double riseX() {
        return 2 * coefficients.getEntry(1);
    }

    /** Of a plane: how much it rises from the lower border to the upper one, metres. */
    double riseY() {
        return -2 * coefficients.getEntry(2);
    }
}
