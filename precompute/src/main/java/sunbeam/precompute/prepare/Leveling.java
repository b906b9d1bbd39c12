package sunbeam.precompute.prepare;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;

/** Leveling of heights: removes offset, tilt, bow, and each line's offset. Missing samples (NaN, infinite) stay missing. */
public enum Leveling {
    NONE,
    MEAN,
    PLANE,
    /** The plane, then each row's mean: removes steps between lines, and all structure that is constant along x. */
    ROWS,
    /** The plane, then each row's median, which is robust against dust. */
    MEDIAN_ROWS,
    QUADRATIC;

    // Relative to the relief; a sum over millions of samples rounds less.
    private static final double ROUNDING = 1e-14;
    // The terms of a polynomial have these exponents.
    private static final int[] POWERS_OF_X = {0, 1, 0, 2, 1, 0};
    private static final int[] POWERS_OF_Y = {0, 0, 1, 0, 1, 2};
    private static final int HIGHEST = 2;

    public boolean takesTilt() {
        return this != NONE && this != MEAN;
    }

    public HeightMap apply(HeightMap field) {
        return switch (this) {
            case NONE -> field;
            // A map whose mean is 0 stays itself, with its cached properties.
            case MEAN ->
                Math.abs(mean(field.heights(), 0, field.heights().length)) <= ROUNDING * field.relief()
                        ? field
                        : centered(withoutPolynomial(field, 1));
            case PLANE -> centered(withoutPolynomial(field, 3));
            case QUADRATIC -> centered(withoutPolynomial(field, 6));
            case ROWS, MEDIAN_ROWS -> centered(withoutRows(PLANE.apply(field)));
        };
    }

    /** After {@link #MEDIAN_ROWS} the mean is that of the differences from the medians, else rounding. */
    private static HeightMap centered(HeightMap field) {
        double mean = mean(field.heights(), 0, field.heights().length);
        return field.map(height -> height - mean);
    }

    private HeightMap withoutRows(HeightMap field) {
        double[] heights = field.heights().clone();
        for (int row = 0; row < field.rows(); row++) {
            int start = row * field.columns();
            int end = start + field.columns();
            double offset = this == ROWS ? mean(heights, start, end) : median(heights, start, end);
            for (int i = start; i < end; i++) {
                heights[i] -= offset;
            }
        }
        return field.with(heights);
    }

    private static double mean(double[] heights, int from, int to) {
        return Arrays.stream(heights, from, to)
                .filter(Double::isFinite)
                .average()
                .orElse(0);
    }

    private static double median(double[] heights, int from, int to) {
        double[] known =
                Arrays.stream(heights, from, to).filter(Double::isFinite).toArray();
        return known.length == 0 ? 0 : StatUtils.percentile(known, 50);
    }

    /**
     * Subtracts the least-squares polynomial with the first 1, 3 or 6 of the terms 1, x, y, x^2, x y, y^2; x and y run from -1 to 1 over the map.
     * An offset is subtracted before the fit, so that it costs no digits. If all samples lie on one line, the pseudo-inverse yields the slope along
     * it.
     */
    private static HeightMap withoutPolynomial(HeightMap map, int terms) {
        double offset = Arrays.stream(map.heights())
                .filter(Double::isFinite)
                .findFirst()
                .orElse(0);
        double[][] normal = new double[terms][terms];
        double[] right = new double[terms];
        double[][] moments = IntStream.range(0, map.rows())
                .parallel()
                .mapToObj(row -> moments(map, row, offset))
                .toArray(double[][]::new);
        for (int row = 0; row < moments.length; row++) {
            double y = relative(row, map.rows());
            for (int j = 0; j < terms; j++) {
                right[j] += moments[row][2 * HIGHEST + 1 + POWERS_OF_X[j]] * Math.pow(y, POWERS_OF_Y[j]);
                for (int k = 0; k < terms; k++) {
                    normal[j][k] += moments[row][POWERS_OF_X[j] + POWERS_OF_X[k]]
                            * Math.pow(y, (double) POWERS_OF_Y[j] + POWERS_OF_Y[k]);
                }
            }
        }
        RealVector fitted = new SingularValueDecomposition(new Array2DRowRealMatrix(normal))
                .getSolver()
                .solve(new ArrayRealVector(right));
        double[] heights = map.heights().clone();
        IntStream.range(0, map.rows()).parallel().forEach(row -> {
            double[] ofRow = new double[HIGHEST + 1];
            for (int j = 0; j < terms; j++) {
                ofRow[POWERS_OF_X[j]] += fitted.getEntry(j) * Math.pow(relative(row, map.rows()), POWERS_OF_Y[j]);
            }
            for (int column = 0, i = row * map.columns(); column < map.columns(); column++, i++) {
                double x = relative(column, map.columns());
                heights[i] = heights[i] - offset - (ofRow[0] + x * (ofRow[1] + x * ofRow[2]));
            }
        });
        return map.with(heights);
    }

    /** Sums over a row of x^0 to x^4, then of the heights times x^0 to x^2. */
    private static double[] moments(HeightMap map, int row, double offset) {
        double[] sums = new double[3 * HIGHEST + 2];
        for (int column = 0; column < map.columns(); column++) {
            double height = map.at(column, row);
            if (Double.isFinite(height)) {
                double x = relative(column, map.columns());
                double power = 1;
                for (int k = 0; k <= 2 * HIGHEST; k++) {
                    sums[k] += power;
                    if (k <= HIGHEST) {
                        sums[2 * HIGHEST + 1 + k] += (height - offset) * power;
                    }
                    power *= x;
                }
            }
        }
        return sums;
    }

    private static double relative(int index, int count) {
        return count == 1 ? 0 : 2.0 * index / (count - 1) - 1;
    }
}
