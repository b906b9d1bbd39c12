package sunbeam.precompute.colortable;

import sunbeam.precompute.numerics.SplineFilter;

/** Interpolation by B-splines of degree 5 (Unser, see {@link SplineFilter}). Where cubic B-splines err by 1 %, these err by 0.1 %. */
final class QuinticSpline {
    static final int TAPS = 6;

    /** A step of the samples farther away changes a coefficient by less than 2e-5 of the step. */
    static final int MARGIN = 14;

    // Table 1 of the paper.
    private static final double[] POLES = {-0.4305753470999738, -0.04309628820326465};

    private QuinticSpline() {}

    /** Returns the coefficients of samples, transposed; overwrites the samples. */
    static float[] coefficients(float[] plane, int rows, int columns) {
        SplineFilter.alongColumns(plane, rows, columns, POLES);
        float[] transposed = new float[plane.length];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                transposed[column * rows + row] = plane[row * columns + column];
            }
        }
        SplineFilter.alongColumns(transposed, columns, rows, POLES);
        return transposed;
    }

    /** Computes the weights of six coefficients, from the sample two before the one below the position, at a fraction beyond it. */
    static void weights(double fraction, double[] weights) {
        // De Boor's recursion: B-splines of degree d from those of degree d - 1.
        weights[0] = 1;
        for (int degree = 1; degree < TAPS; degree++) {
            double carried = 0;
            for (int i = 0; i < degree; i++) {
                double right = i + 1 - fraction;
                double left = fraction + degree - 1 - i;
                double share = weights[i] / degree;
                weights[i] = carried + right * share;
                carried = left * share;
            }
            weights[degree] = carried;
        }
    }
}
