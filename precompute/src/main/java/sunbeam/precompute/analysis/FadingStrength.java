package sunbeam.precompute.analysis;

import java.util.Arrays;
import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;

/** A wave that is strongest in the middle of a scan and fades evenly to its sides. */
final class FadingStrength {
    private static final int FEWEST = 6;
    // Of the variance of the strengths, what a parabola leaves.
    private static final double REST = 0.1;

    private FadingStrength() {}

    /**
     * Difference over sum of the strengths in the middle and at the sides, where they lie on a parabola that falls to both; 0 where they
     * do not.
     *
     * @param strengths at equal distances
     */
    static double sag(double[] strengths) {
        int count = strengths.length;
        if (count < FEWEST) {
            return 0;
        }
        WeightedObservedPoints points = new WeightedObservedPoints();
        for (int i = 0; i < count; i++) {
            points.add(place(i, count), strengths[i]);
        }
        double[] parabola = PolynomialCurveFitter.create(2).fit(points.toList());
        double mean = Arrays.stream(strengths).average().orElse(0);
        double variance = 0;
        double rest = 0;
        for (int i = 0; i < count; i++) {
            double t = place(i, count);
            double off = strengths[i] - (parabola[0] + t * (parabola[1] + t * parabola[2]));
            rest += off * off;
            variance += (strengths[i] - mean) * (strengths[i] - mean);
        }
        double top = parabola[0];
        double side = parabola[0] + parabola[2];
        boolean fades = parabola[2] < 0 && Math.abs(parabola[1]) < Math.abs(parabola[2]) && rest <= REST * variance;
        return fades && top > 0 ? Math.min(1, (top - side) / Math.max(top + side, 1e-3 * top)) : 0;
    }

    /** From -1 to 1. */
    private static double place(int i, int count) {
        return 2.0 * i / (count - 1) - 1;
    }
}
