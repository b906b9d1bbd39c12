package sunbeam.precompute.errors;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import org.apache.commons.math3.util.MathArrays;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.plan.ErrorBudget;

/** Computed and exact X, Y, Z, or power, with the same factor from power to radiance. */
public record Comparison(double[] computed, double[] exact, double gain) {
    /** Power, or largest X, Y, Z of power, below which relative errors are meaningless. */
    public static final double FLOOR = ErrorBudget.DARKEST_POWER;

    public static Comparison ofPower(double computed, double exact) {
        return new Comparison(new double[] {computed}, new double[] {exact}, 1);
    }

    public static double[] xyz(float[] values, int place) {
        return new double[] {values[3 * place], values[3 * place + 1], values[3 * place + 2]};
    }

    public static double largest(double[] values) {
        return Arrays.stream(values).max().orElseThrow();
    }

    /** True if X, Y, Z of power are bright enough to be compared. */
    public static boolean isBright(double[] xyz) {
        return largest(xyz) > FLOOR;
    }

    /** True if either value without the gain, which is infinite at the horizon, exceeds {@link #FLOOR}, or is NaN. */
    public boolean bright() {
        return !(Math.max(largest(computed), largest(exact)) <= FLOOR * gain);
    }

    /** Returns the largest difference over the largest exact value, so that a nearly dark channel does not dominate. */
    public double relative() {
        return MathArrays.distanceInf(computed, exact) / Math.max(FLOOR * gain, largest(exact));
    }

    public double colorDifference(double exposure) {
        return lab(computed, exposure).difference(lab(exact, exposure));
    }

    private static CieLab lab(double[] xyz, double exposure) {
        return CieLab.ofXyz(exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]);
    }

    public static ErrorStatistics relative(List<Comparison> compared) {
        DoubleStream errors = compared.stream().filter(Comparison::bright).mapToDouble(Comparison::relative);
        return ErrorStatistics.of(errors.toArray());
    }
}
