package sunbeam.precompute.patch;

import java.util.Locale;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.units.Decimals;

/**
 * How much of the reflected light scalar theory sends elsewhere than Maxwell's equations do, by a rule: a power of the mean
 * slope, fitted to 1500 gratings by rigorous coupled-wave analysis (docs/theory.md, docs/examples/coupled_waves.py). The
 * sum over all directions of what is drawn too bright or too dark, over all that is reflected.
 *
 * @param meanSlope mean of |grad h| over the patch, without unit; for a grating twice its depth over its period
 */
public record ModelError(double meanSlope) {
    /** Steeper surfaces have no rule: as much light goes elsewhere as where it is drawn. */
    public static final double LARGEST_SLOPE = 1.2;

    /** Light from 0 to 30, 30 to 60, 60 to 75 degrees off the normal. */
    public enum Incidence {
        NEAR_NORMAL(0.742, 1.271, 0.36, 2.46),
        OBLIQUE(0.754, 0.757, 0.43, 2.37),
        GRAZING(1.063, 0.738, 0.33, 2.25);

        private final double factor;
        private final double exponent;
        private final double low;
        private final double high;

        Incidence(double factor, double exponent, double low, double high) {
            this.factor = factor;
            this.exponent = exponent;
            this.low = low;
            this.high = high;
        }
    }

    /** Of a surface without missing samples; the seam between repetitions is no measured slope. */
    public static ModelError of(HeightMap map) {
        double sum = 0;
        int columns = Math.max(1, map.columns() - 1);
        int rows = Math.max(1, map.rows() - 1);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                sum += SlopeCheck.slope(map, column, row);
            }
        }
        return new ModelError(sum / ((double) columns * rows));
    }

    /** Whether the rule knows anything. */
    public boolean hasRule() {
        return meanSlope <= LARGEST_SLOPE;
    }

    /** The expected share of the reflected light; of ten gratings eight lie between {@link #low} and {@link #high}. */
    public double expected(Incidence incidence) {
        return incidence.factor * Math.pow(meanSlope, incidence.exponent);
    }

    public double low(Incidence incidence) {
        return incidence.low * expected(incidence);
    }

    public double high(Incidence incidence) {
        return incidence.high * expected(incidence);
    }

    /** What light near the normal is drawn wrong, for people: "about 12 %". */
    String share() {
        return hasRule() ? "about " + percent(expected(Incidence.NEAR_NORMAL)) : "half or more";
    }

    /** One line for people. */
    public String describe() {
        if (!hasRule()) {
            return String.format(
                    Locale.ROOT,
                    "mean slope %.2f, beyond the rule: about as much light goes elsewhere as where it is drawn (docs/theory.md)",
                    meanSlope);
        }
        return String.format(
                        Locale.ROOT,
                        "about %s of the reflected light is drawn elsewhere than it goes (%s to %s) with light up to 30 degrees from the",
                        percent(expected(Incidence.NEAR_NORMAL)),
                        percent(low(Incidence.NEAR_NORMAL)),
                        percent(high(Incidence.NEAR_NORMAL)))
                + String.format(
                        Locale.ROOT,
                        " normal, %s up to 60, %s up to 75 (mean slope %s; docs/theory.md)",
                        percent(expected(Incidence.OBLIQUE)),
                        percent(expected(Incidence.GRAZING)),
                        Decimals.rounded(meanSlope, 2));
    }

    private static String percent(double share) {
        return share >= 1 ? "all" : Decimals.rounded(100 * share, 2) + " %";
    }
}
