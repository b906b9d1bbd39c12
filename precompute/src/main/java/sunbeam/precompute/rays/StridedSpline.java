package sunbeam.precompute.rays;

/**
 * Smooth sequences as sums of cubic B-splines at every stride-th place, by least squares: a convolution with such a sequence is one with
 * the B-spline, an average of which every stride-th counts, and one with the few coefficients. Nothing of a sequence reaches farther than four
 * strides beyond its ends. Immutable.
 */
final class StridedSpline {
    // On each side, that a B-spline overlaps.
    private static final int NEIGHBORS = 3;

    private final int stride;
    private final int length;
    private final double[] taps;
    private final int firstKnot;
    private final int knots;
    private final double[][] factor;

    /**
     * For sequences of a length.
     *
     * @param stride places from one B-spline to the next, 2 or more
     * @param length of the sequences, from place 0 on
     */
    StridedSpline(int stride, int length) {
        this.stride = stride;
        this.length = length;
        this.taps = taps(stride);
        this.firstKnot = firstKnot(stride);
        this.knots = knots(stride, length);
        this.factor = factor();
    }

    /** A cubic B-spline at the places that it reaches; their sum is 1. */
    private static double[] taps(int stride) {
        double[] taps = new double[4 * stride - 1];
        for (int i = 0; i < taps.length; i++) {
            double distance = Math.abs((double) (i + 1) / stride - 2);
            double rest = 2 - distance;
            taps[i] = (distance < 1 ? 4 - 3 * distance * distance * rest : rest * rest * rest) / (6 * stride);
        }
        return taps;
    }

    /**
     * Cholesky's factor of the B-splines' scalar products, of which only neighbors have any: {@code [row][distance from the diagonal]}.
     */
    private double[][] factor() {
        double[] products = new double[NEIGHBORS + 1];
        for (int distance = 0; distance <= NEIGHBORS; distance++) {
            for (int i = distance * stride; i < taps.length; i++) {
                products[distance] += taps[i] * taps[i - distance * stride];
            }
        }
        double[][] factor = new double[knots][NEIGHBORS + 1];
        for (int row = 0; row < knots; row++) {
            for (int distance = Math.min(row, NEIGHBORS); distance >= 0; distance--) {
                int column = row - distance;
                double rest = products[distance];
                for (int k = Math.max(0, row - NEIGHBORS); k < column; k++) {
                    rest -= factor[row][row - k] * factor[column][column - k];
                }
                factor[row][distance] = distance == 0 ? Math.sqrt(rest) : rest / factor[column][0];
            }
        }
        return factor;
    }

    private static int firstKnot(int stride) {
        return -((4 * stride - 2) / stride);
    }

    /** B-splines of a sequence. */
    static int knots(int stride, int length) {
        return (length - 1) / stride - firstKnot(stride) + 1;
    }

    /** B-splines of a sequence. */
    int knots() {
        return knots;
    }

    /** First place that any of them reaches, before the sequence's. */
    private int first() {
        return firstKnot * stride;
    }

    /** Where the first of them has its middle, a place before the sequence's first. */
    int firstMiddle() {
        return first() + 2 * stride - 1;
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
        return solved(products);
    }

    /** The normal equations' solution, in place. */
    private double[] solved(double[] values) {
        for (int row = 0; row < knots; row++) {
            for (int distance = 1; distance <= Math.min(row, NEIGHBORS); distance++) {
                values[row] -= factor[row][distance] * values[row - distance];
            }
            values[row] /= factor[row][0];
        }
        for (int row = knots - 1; row >= 0; row--) {
            for (int distance = 1; distance <= Math.min(knots - 1 - row, NEIGHBORS); distance++) {
                values[row] -= factor[row + distance][distance] * values[row + distance];
            }
            values[row] /= factor[row][0];
        }
        return values;
    }
}
