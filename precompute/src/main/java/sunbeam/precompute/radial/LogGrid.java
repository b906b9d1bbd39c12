package sunbeam.precompute.radial;

/**
 * Knots of cubic B-splines along a ray, equally spaced in ln |f|.
 *
 * @param first ln |f| of the first knot, f in cycles per meter
 */
record LogGrid(double first, double spacing, int count) {
    /** Half the support of a B-spline, in knots. */
    static final int REACH = 2;

    /** Returns the lowest |f| in the support of any spline, in cycles per meter. */
    double lowest() {
        return Math.exp(first - REACH * spacing);
    }

    double highest() {
        return Math.exp(first + (count - 1 + REACH) * spacing);
    }
}
