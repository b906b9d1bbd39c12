package sunbeam.precompute.rays;

import java.util.Arrays;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.DecompositionSolver;

/**
 * Smooth sequences as sums of cubic B-splines at every stride-th place, by least squares: a convolution with such a sequence is one with
 * the B-spline, of which every stride-th value counts, and one with the few coefficients. Each B-spline is four boxes convolved, so
 * that nothing of a sequence reaches farther than three strides beyond its ends. With a stride of one the coefficients are the
 * sequence. Immutable.
 */
final class StridedSpline {
    private static final int BOXES = 4;

    private final int stride;
    private final int length;
    private final double[] taps;
    private final int firstKnot;
    private final int knots;
    private final DecompositionSolver normalEquations;

    /**
     * For sequences of a length.
     *
     * @param stride places from one B-spline to the next, 1 or more
     * @param length of the sequences, from place 0 on
     */
    StridedSpline(int stride, int length) {
        this.stride = stride;
        this.length = length;
        this.taps = boxes(stride);
        this.firstKnot = firstKnot(stride);
        this.knots = knots(stride, length);
        this.normalEquations = new CholeskyDecomposition(new Array2DRowRealMatrix(products(), false)).getSolver();
    }

    /** Boxes of a width, convolved, with the sum of a single box. */
    private static double[] boxes(int width) {
        double[] spline = {width};
        for (int box = 0; box < BOXES; box++) {
            double[] wider = new double[spline.length + width - 1];
            for (int i = 0; i < spline.length; i++) {
                for (int k = 0; k < width; k++) {
                    wider[i + k] += spline[i] / width;
                }
            }
            spline = wider;
        }
        return spline;
    }

    /** Scalar products of the B-splines. */
    private double[][] products() {
        double[][] products = new double[knots][knots];
        for (int one = 0; one < knots; one++) {
            for (int other = one; other < knots && (other - one) * stride < taps.length; other++) {
                double product = 0;
                for (int i = (other - one) * stride; i < taps.length; i++) {
                    product += taps[i] * taps[i - (other - one) * stride];
                }
                products[one][other] = product;
                products[other][one] = product;
            }
        }
        return products;
    }

    private static int firstKnot(int stride) {
        return -(BOXES * (stride - 1) / stride);
    }

    /** B-splines of a sequence. */
    static int knots(int stride, int length) {
        return (length - 1) / stride - firstKnot(stride) + 1;
    }

    /** B-splines of a sequence. */
    int knots() {
        return knots;
    }

    /** First place that any of them reaches, 0 or less. */
    int first() {
        return firstKnot * stride;
    }

    /** Last place that any of them reaches, the sequence's last one or more. */
    int last() {
        return first() + (knots - 1) * stride + taps.length - 1;
    }

    /** The coefficients that come nearest to a sequence, beyond whose ends are zeros. */
    double[] coefficients(double[] sequence) {
        double[] products = new double[knots];
        for (int knot = 0; knot < knots; knot++) {
            int begin = first() + knot * stride;
            for (int i = Math.max(0, -begin); i < taps.length && begin + i < length; i++) {
                products[knot] += taps[i] * sequence[begin + i];
            }
        }
        return normalEquations.solve(new ArrayRealVector(products, false)).toArray();
    }

    /**
     * Convolves with a B-spline.
     *
     * @param values {@code stride * (count - 1)} and as many as a B-spline has
     * @param smoothed takes every stride-th place's; zeros behind them
     */
    void smooth(double[] values, double[] smoothed, int count) {
        for (int place = 0; place < count; place++) {
            double sum = 0;
            int at = place * stride;
            for (int i = 0; i < taps.length; i++) {
                sum += taps[i] * values[at + i];
            }
            smoothed[place] = sum;
        }
        Arrays.fill(smoothed, count, smoothed.length, 0);
    }

    /** Values that {@link #smooth} reads. */
    int read(int count) {
        return stride * (count - 1) + taps.length;
    }
}
