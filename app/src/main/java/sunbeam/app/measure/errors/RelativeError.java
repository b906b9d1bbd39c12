package sunbeam.app.measure.errors;

/** Errors relative to the exact value. */
public final class RelativeError {
    /** Power, and largest of X, Y, Z of power, below which an error relative to it means nothing. */
    public static final double FLOOR = 1e-9;

    private RelativeError() {}

    /** Of a power. */
    public static double of(double value, double exact) {
        return Math.abs(value - exact) / exact;
    }

    /**
     * Of a color: the largest difference in X, Y or Z by the largest of the exact X, Y and Z, so that a channel that is
     * nearly absent does not count for more than can be seen.
     */
    public static double ofColor(double[] xyz, double[] exact) {
        return difference(xyz, exact) / largest(exact);
    }

    /** The largest difference in X, Y or Z; NaN if one of them is. */
    public static double difference(double[] values, double[] exact) {
        double result = 0;
        for (int c = 0; c < exact.length; c++) {
            result = Math.max(result, Math.abs(values[c] - exact[c]));
        }
        return result;
    }

    /** The largest of X, Y and Z. */
    public static double largest(double[] values) {
        double result = values[0];
        for (double value : values) {
            result = Math.max(result, value);
        }
        return result;
    }
}
