package sunbeam.precompute.numerics;

/** Lagrange's polynomials through equally spaced places. */
public final class Lagrange {
    private Lagrange() {}

    /**
     * The polynomial that is 1 at one of the places 0 to taps - 1 and 0 at the others.
     *
     * @param at where, in distances of the places from the first
     * @param tap which is 1 there
     */
    public static double weight(double at, int tap, int taps) {
        double weight = 1;
        for (int other = 0; other < taps; other++) {
            weight *= other == tap ? 1 : (at - other) / (tap - other);
        }
        return weight;
    }
}
