package sunbeam.precompute.prepare;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * The least-squares polynomial through heights, of first or second degree in x and y, over coordinates from -1 to 1 that are
 * centred on the samples that count; where these lie on one line, the pseudo-inverse takes the slope along it. Missing
 * samples take no part.
 */
final class Polynomial {
    private final HeightField field;
    private final double offset;
    private final double centreX;
    private final double centreY;
    private final RealVector coefficients;

    private Polynomial(HeightField field, double offset, double centreX, double centreY, RealVector coefficients) {
        this.field = field;
        this.offset = offset;
        this.centreX = centreX;
        this.centreY = centreY;
        this.coefficients = coefficients;
    }

    /**
     * Fits.
     *
     * @param terms 1 for the mean, 3 for a plane, 6 for a quadratic surface
     */
    static Polynomial fit(HeightField field, int terms) {
        double sumX = 0;
        double sumY = 0;
        double first = Double.NaN;
        long count = 0;
        for (int i = 0; i < field.heights().length; i++) {
            if (Double.isFinite(field.heights()[i])) {
                first = count == 0 ? field.heights()[i] : first;
                sumX += field.relativeX(i % field.columns());
                sumY += field.relativeY(i / field.columns());
                count++;
            }
        }
        double centreX = count == 0 ? 0 : sumX / count;
        double centreY = count == 0 ? 0 : sumY / count;
        double[][] normal = new double[terms][terms];
        double[] right = new double[terms];
        double[] values = new double[terms];
        for (int i = 0; i < field.heights().length; i++) {
            if (Double.isFinite(field.heights()[i])) {
                fill(
                        values,
                        field.relativeX(i % field.columns()) - centreX,
                        field.relativeY(i / field.columns()) - centreY);
                // Relative to one of them, so that a large common offset costs no digits.
                double height = field.heights()[i] - first;
                for (int j = 0; j < terms; j++) {
                    right[j] += values[j] * height;
                    for (int k = 0; k <= j; k++) {
                        normal[j][k] += values[j] * values[k];
                    }
                }
            }
        }
        for (int j = 0; j < terms; j++) {
            for (int k = 0; k < j; k++) {
                normal[k][j] = normal[j][k];
            }
        }
        RealVector fitted = new ArrayRealVector(terms);
        if (count > 0) {
            fitted = new SingularValueDecomposition(new Array2DRowRealMatrix(normal))
                    .getSolver()
                    .solve(new ArrayRealVector(right));
        }
        return new Polynomial(field, count == 0 ? 0 : first, centreX, centreY, fitted);
    }

    private static void fill(double[] values, double x, double y) {
        values[0] = 1;
        if (values.length > 1) {
            values[1] = x;
            values[2] = y;
        }
        if (values.length > 3) {
            values[3] = x * x;
            values[4] = x * y;
            values[5] = y * y;
        }
    }

    /** The heights less the polynomial. */
    HeightField subtracted() {
        double[] values = new double[coefficients.getDimension()];
        double[] heights = field.heights().clone();
        for (int i = 0; i < heights.length; i++) {
            fill(
                    values,
                    field.relativeX(i % field.columns()) - centreX,
                    field.relativeY(i / field.columns()) - centreY);
            double polynomial = 0;
            for (int j = 0; j < values.length; j++) {
                polynomial += coefficients.getEntry(j) * values[j];
            }
            heights[i] = heights[i] - offset - polynomial;
        }
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
