package sunbeam.precompute.errors;

import java.util.List;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.plan.ErrorBudget;

/**
 * What was computed at one place, and what is exact there.
 *
 * @param computed X, Y, Z, or a power alone
 * @param exact the same by the reference
 * @param gain by which both were multiplied
 */
public record Comparison(double[] computed, double[] exact, double gain) {
    /** Power, and largest of X, Y, Z of power, below which an error relative to it means nothing. */
    public static final double FLOOR = ErrorBudget.DARKEST_POWER;

    /** Of a power alone. */
    public static Comparison ofPower(double computed, double exact) {
        return new Comparison(new double[] {computed}, new double[] {exact}, 1);
    }

    /** X, Y and Z of a place, of values with three a place. */
    public static double[] xyz(float[] values, int place) {
        return new double[] {values[3 * place], values[3 * place + 1], values[3 * place + 2]};
    }

    /** The largest of X, Y and Z. */
    public static double largest(double[] values) {
        double result = values[0];
        for (double value : values) {
            result = Math.max(result, value);
        }
        return result;
    }

    /** True if X, Y, Z of power are bright enough to be compared. */
    public static boolean isBright(double[] xyz) {
        return largest(xyz) > FLOOR;
    }

    /** Whether either has enough light; the gain, which is not finite at the horizon, does not count. */
    public boolean bright() {
        // Written so that a NaN is looked at.
        return !(Math.max(largest(computed), largest(exact)) <= FLOOR * gain);
    }

    /**
     * The largest difference in X, Y or Z by the largest of the exact X, Y and Z, so that a channel that is nearly absent does
     * not count for more than can be seen. Light where there should be none is measured by the floor.
     */
    public double relative() {
        double difference = 0;
        for (int c = 0; c < exact.length; c++) {
            difference = Math.max(difference, Math.abs(computed[c] - exact[c]));
        }
        return difference / Math.max(FLOOR * gain, largest(exact));
    }

    /** CIEDE2000 of X, Y, Z after an exposure. */
    public double colorDifference(double exposure) {
        return ColorDifference.ciede2000(lab(computed, exposure), lab(exact, exposure));
    }

    private static CieLab lab(double[] xyz, double exposure) {
        return CieLab.ofXyz(exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]);
    }

    /** Relative errors of those that are bright. */
    public static ErrorStatistics relative(List<Comparison> compared) {
        return ErrorStatistics.of(compared.stream()
                .filter(Comparison::bright)
                .mapToDouble(Comparison::relative)
                .toArray());
    }
}
