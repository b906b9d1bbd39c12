package sunbeam.precompute.numerics;

/** Lagrange polynomials through equally spaced points. */
public final class Lagrange {
    private Lagrange() {}

    /** Evaluates the polynomial that is 1 at the point {@code tap} of 0 to taps - 1, and 0 at the others. */
    public static double weight(double at, int tap, int taps) {
        double weight = 1;
        for (int other = 0; other < taps; other++) {
            weight *= other == tap ? 1 : (at - other) / (tap - other);
        }
        return weight;
    }
}
