package sunbeam.precompute.analysis;

import java.util.OptionalDouble;
import java.util.function.Predicate;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * Waves among which a period is looked for: all, or those that a user states.
 *
 * @param azimuth across the lines, radians counter-clockwise from +x, within 2 degrees; empty for any
 * @param shortest period in meters; 0 for any
 * @param longest period in meters; infinite for any
 */
record Hypothesis(OptionalDouble azimuth, double shortest, double longest) implements Predicate<SpatialFrequency> {
    static final Hypothesis ANY = new Hypothesis(OptionalDouble.empty(), 0, Double.POSITIVE_INFINITY);

    // Sine of 2 degrees.
    static final double CONE = 0.035;

    @Override
    public boolean test(SpatialFrequency wave) {
        double angle = azimuth.orElse(0);
        SpatialFrequency direction = new SpatialFrequency(Math.cos(angle), Math.sin(angle));
        return wave.length() > 0
                && wave.period() >= shortest
                && wave.period() <= longest
                && (azimuth.isEmpty() || wave.sineTo(direction) < CONE);
    }

    boolean isStated() {
        return !equals(ANY);
    }

    /** Returns the start of the reason why no period is found. */
    String nothing() {
        if (!isStated()) {
            return "no order found: a white gloss without color";
        }
        String range = longest < Double.POSITIVE_INFINITY
                ? " with a period of " + Lengths.rounded(shortest, 3) + " to " + Lengths.rounded(longest, 3)
                : "";
        String where = azimuth.isPresent()
                ? " along azimuth " + Decimals.format(Math.rint(100 * Math.toDegrees(azimuth.getAsDouble())) / 100)
                        + " degrees"
                : "";
        return "no order found" + range + where;
    }
}
