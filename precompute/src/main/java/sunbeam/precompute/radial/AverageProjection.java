package sunbeam.precompute.radial;

import org.apache.commons.math3.analysis.polynomials.PolynomialFunction;

/**
 * Projects a weight sequence s onto cubic B-spline averages of a function f: sum_i s_i f(i) = sum_k c_k avg_k(f), with one average at every
 * stride-th index. Between averages f is the polynomial of degree 11 that has the twelve averages around, so s may jump (as the light of a
 * filter does) where f is smooth; where s is smooth, f need not be. Immutable.
 */
final class AverageProjection {
    private static final int POINTS = 12;
    private static final int BEFORE = POINTS / 2 - 1;

    private final int stride;
    private final int knots;
    // [index in s modulo stride][average]: share of a value in the c_k of the twelve averages around.
    private final double[][] weights;

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

    /** Returns the Lagrange polynomial that is 1 at {@code point - BEFORE} and 0 at the other points. */
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

    /** Returns the polynomial whose averages are given. Each iteration corrects two more degrees. */
    private static PolynomialFunction withAverage(PolynomialFunction averages) {
        PolynomialFunction polynomial = averages;
        for (int right = 2; right < POINTS; right += 2) {
            polynomial = polynomial.add(averages.subtract(average(polynomial)));
        }
        return polynomial;
    }

    private static PolynomialFunction average(PolynomialFunction polynomial) {
        return overBox(overBox(overBox(overBox(polynomial))));
    }

    /** Averages over [x - 1/2, x + 1/2]: the sum over n of p^(2n)(x) (1/2)^(2n) / (2n + 1)!. */
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

    static int knots(int stride, int length) {
        return (length - 1) / stride + POINTS;
    }

    int knots() {
        return knots;
    }

    /** Returns the index at the center of the first average, which lies before the sequence. */
    int firstMiddle() {
        return -BEFORE * stride;
    }

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
