package sunbeam.precompute.radial;

/**
 * Places of cubic B-splines along a ray, equally far apart in the logarithm of the frequency.
 *
 * @param first ln of the first one's frequency, in cycles per metre
 * @param spacing of ln
 * @param count of them
 */
record LogGrid(double first, double spacing, int count) {
    /** Knots on each side of a place that reach it. */
    static final int REACH = 2;

    /** Lowest frequency that any of them reaches. */
    double lowest() {
        return Math.exp(first - REACH * spacing);
    }

    /** Highest frequency that any of them reaches. */
    double highest() {
        return Math.exp(first + (count - 1 + REACH) * spacing);
    }
}
