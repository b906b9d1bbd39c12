package sunbeam.precompute.numerics;

/** Lagrange polynomials through equally spaced points. */
public final class Lagrange {
    private Lagrange() {}

    /**
     * Evaluates the polynomial that is 1 at one of the points 0 to taps - 1 and 0 at the others.
     *
     * @param at position from the first point, in steps
     * @param tap the point where the polynomial is 1
     */
    public static double weight(double at, int tap, int taps) {
        double weight = 1;
        for (int other = 0; other < taps; other++) {
            weight *= other == tap ? 1 : (at - other) / (tap - other);
        }
        return weight;
    }
}
