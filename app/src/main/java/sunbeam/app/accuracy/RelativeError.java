package sunbeam.app.accuracy;

/** Errors relative to the exact value. */
public final class RelativeError {
    private RelativeError() {}

    /** Of a power. */
    public static double of(double value, double exact) {
        return Math.abs(value - exact) / exact;
    }

    /**
     * Of a colour: the largest difference in X, Y or Z by the largest of the exact X, Y and Z, so that a channel that is
     * nearly absent does not count for more than can be seen.
     */
    public static double ofColor(double[] xyz, double[] exact) {
        return difference(xyz, exact) / largest(exact);
    }

    /** The largest difference in X, Y or Z; NaN if one of them is. */
    static double difference(double[] xyz, double[] exact) {
        double result = 0;
        for (int c = 0; c < 3; c++) {
            result = Math.max(result, Math.abs(xyz[c] - exact[c]));
        }
        return result;
    }

    /** The largest of X, Y and Z. */
    static double largest(double[] xyz) {
        return Math.max(xyz[0], Math.max(xyz[1], xyz[2]));
    }
}
