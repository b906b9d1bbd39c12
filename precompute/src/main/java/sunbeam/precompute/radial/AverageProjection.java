package sunbeam.precompute.radial;

import org.apache.commons.math3.analysis.polynomials.PolynomialFunction;

/**
 * What a sequence counts of a function, as what averages of the function count: averages by cubic B-splines at every stride-th place. Between them
 * the function is the polynomial of degree 11 that has the twelve averages around. So a sequence may jump, as the light of a filter does,
 * where the function is smooth from average to average; where the sequence is smooth the function need not be, since the
 * coefficients of smooth sequences are those of the spline that comes nearest. Nothing of a sequence reaches farther than eight strides beyond
 * its ends. Immutable.
 */
final class AverageProjection {
    private static final int POINTS = 12;
    private static final int BEFORE = POINTS / 2 - 1;

    private final int stride;
    private final int knots;
    // Of a place so many behind an average: what the averages around count.
    private final double[][] weights;

    /**
     * For sequences of a length.
     *
     * @param stride places from one average to the next
     * @param length of the sequences, from place 0 on
     */
    AverageProjection(int stride, int length) {
        this.stride = stride;
        this.knots = knots(stride, length);
        this.weights = new double[stride][POINTS];
        for (int point = 0; point < POINTS; point++) {
            PolynomialFunction polynomial = withAverage(lagrange(point));
            for (int behind = 0; behind < stride; behind++) {
                weights[behind][point] = polynomial.value((double) behind / stride);
            }
        }
    }

    /** 1 at one of the places -BEFORE to POINTS - BEFORE - 1 and 0 at the others. */
    private static PolynomialFunction lagrange(int point) {
        PolynomialFunction product = new PolynomialFunction(new double[] {1});
        for (int other = 0; other < POINTS; other++) {
            if (other != point) {
                double slope = 1.0 / (point - other);
                product = product.multiply(new PolynomialFunction(new double[] {(BEFORE - other) * slope, slope}));
            }
        }
        return product;
    }

    /** The polynomial whose averages a polynomial is. Each round leaves two degrees less to correct. */
    private static PolynomialFunction withAverage(PolynomialFunction averages) {
        PolynomialFunction polynomial = averages;
        for (int right = 2; right < POINTS; right += 2) {
            polynomial = polynomial.add(averages.subtract(average(polynomial)));
        }
        return polynomial;
    }

    /** By a cubic B-spline, which is a box, averaged over three more. */
    private static PolynomialFunction average(PolynomialFunction polynomial) {
        return overBox(overBox(overBox(overBox(polynomial))));
    }

    /** From 1/2 before to 1/2 behind a place: the sum over n of p^(2n) (1/2)^2n / (2n + 1)!. */
    private static PolynomialFunction overBox(PolynomialFunction polynomial) {
        PolynomialFunction sum = polynomial;
        PolynomialFunction derivative = polynomial;
        double factor = 1;
        for (int n = 1; 2 * n < POINTS; n++) {
            derivative = derivative.polynomialDerivative().polynomialDerivative();
            factor /= 4.0 * (2 * n) * (2 * n + 1);
            sum = sum.add(derivative.multiply(new PolynomialFunction(new double[] {factor})));
        }
        return sum;
    }

    /** Averages that a sequence counts. */
    static int knots(int stride, int length) {
        return (length - 1) / stride + POINTS;
    }

    /** Averages that a sequence counts. */
    int knots() {
        return knots;
    }

    /** Where the first of them has its middle, a place before the sequence's first. */
    int firstMiddle() {
        return -BEFORE * stride;
    }

    /** What each average counts. */
    double[] coefficients(double[] sequence) {
        double[] coefficients = new double[knots];
        for (int i = 0; i < sequence.length; i++) {
            double[] shares = weights[i % stride];
            for (int point = 0; point < POINTS; point++) {
                coefficients[i / stride + point] += sequence[i] * shares[point];
            }
        }
        return coefficients;
    }
}
