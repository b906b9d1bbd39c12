package sunbeam.app.cli.export;

/**
 * A density that is linear between equally spaced nodes, as tensor files define it along each axis.
 *
 * @param sums integral of the density up to each node; the distance between nodes is 1
 * @param values density at each node, not negative, not all 0
 */
record LinearDensity(double[] sums, double[] values) {
    static LinearDensity of(double[] values) {
        double[] sums = new double[values.length];
        for (int i = 1; i < values.length; i++) {
            sums[i] = sums[i - 1] + 0.5 * (values[i - 1] + values[i]);
        }
        return new LinearDensity(sums, values);
    }

    double total() {
        return sums[sums.length - 1];
    }

    double at(double place) {
        int below = below(place);
        return values[below] + (place - below) * (values[below + 1] - values[below]);
    }

    /** Returns the integral up to a fractional node index, relative to the whole integral, 0 to 1. */
    double share(double place) {
        int below = below(place);
        double beyond = place - below;
        double slope = values[below + 1] - values[below];
        return (sums[below] + beyond * (values[below] + 0.5 * beyond * slope)) / total();
    }

    /** Returns the fractional node index up to which the integral is this share of the whole; the inverse of {@link #share}. */
    double place(double share) {
        double wanted = share * total();
        int below = 0;
        while (below < sums.length - 2 && sums[below + 1] < wanted) {
            below++;
        }
        double rest = Math.max(0, wanted - sums[below]);
        double slope = values[below + 1] - values[below];
        // The root of rest = value x + slope x^2 / 2, in a form that is stable for every slope.
        double root = Math.sqrt(Math.max(0, values[below] * values[below] + 2 * slope * rest));
        double sum = values[below] + root;
        return below + (sum > 0 ? Math.min(1, 2 * rest / sum) : 0);
    }

    private int below(double place) {
        return Math.max(0, Math.min(values.length - 2, (int) place));
    }
}
