package sunbeam.precompute.numerics;

import java.util.Map;
import java.util.NavigableMap;

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

    /**
     * Returns the maximum of the parabola through the logarithms of three samples, exact for a Gaussian: in steps from the middle, within
     * half a step; 0 if a sample is not positive or the logarithms not concave.
     */
    public static double top(double before, double here, double after) {
        double logBefore = Math.log(before);
        double logAfter = Math.log(after);
        double curvature = logBefore - 2 * Math.log(here) + logAfter;
        if (!(curvature < 0) || !Double.isFinite(curvature)) {
            return 0;
        }
        return Math.max(-0.5, Math.min(0.5, 0.5 * (logBefore - logAfter) / curvature));
    }

    /** Returns the value at a place, linear between a table's entries and constant beyond them; the table has at least one. */
    public static double between(NavigableMap<Double, Double> table, double place) {
        Map.Entry<Double, Double> below = table.floorEntry(place);
        Map.Entry<Double, Double> above = table.ceilingEntry(place);
        if (below == null || above == null) {
            return (below == null ? above : below).getValue();
        }
        double gap = above.getKey() - below.getKey();
        double share = gap > 0 ? (place - below.getKey()) / gap : 0;
        return below.getValue() + share * (above.getValue() - below.getValue());
    }
}
