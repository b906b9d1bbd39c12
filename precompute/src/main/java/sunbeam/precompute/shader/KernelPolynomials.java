package sunbeam.precompute.shader;

import java.util.StringJoiner;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.polynomials.PolynomialFunctionLagrangeForm;
import sunbeam.precompute.text.Text;

/**
 * Interpolation kernel as polynomials (shaders/method/grid_tables.glsl): the weight of each tap as a function of x = 2 fraction - 1 in [-1,
 * 1], through the kernel at Chebyshev nodes. Compared with a table there is nothing to fetch, and float32 rounds relative to each tap's own
 * weight: on the skirt of a bright order the outermost tap meets a sample a thousand times brighter than the result.
 */
public record KernelPolynomials(double[][] coefficients) {
    // For a kernel of peak 1; a thousand times this, on a skirt, is still below float32's rounding.
    private static final double ERROR = 2e-9;
    private static final int MOST_POWERS = 16;
    private static final int CHECKED = 64;

    /**
     * Returns the polynomials with the fewest powers, the same for all taps.
     *
     * @param kernel weight of a sample by its distance in samples; smooth within {@code taps / 2}
     * @throws IllegalArgumentException for a kernel that is not smooth
     */
    public static KernelPolynomials of(int taps, DoubleUnaryOperator kernel) {
        for (int powers = 4; powers <= MOST_POWERS; powers++) {
            int count = powers;
            KernelPolynomials polynomials = new KernelPolynomials(IntStream.range(0, taps)
                    .mapToObj(tap -> through(x -> kernel.applyAsDouble(distance(taps, tap, x)), count))
                    .toArray(double[][]::new));
            if (polynomials.largestError(kernel) <= ERROR) {
                return polynomials;
            }
        }
        throw new IllegalArgumentException("no polynomial of " + MOST_POWERS + " powers is near the kernel");
    }

    private static double distance(int taps, int tap, double x) {
        return (x + 1) / 2 + 0.5 * taps - 1 - tap;
    }

    private static double[] through(DoubleUnaryOperator function, int powers) {
        double[] places = IntStream.range(0, powers)
                .mapToDouble(i -> Math.cos(Math.PI * (i + 0.5) / powers))
                .toArray();
        double[] values = IntStream.range(0, powers)
                .mapToDouble(i -> function.applyAsDouble(places[i]))
                .toArray();
        return new PolynomialFunctionLagrangeForm(places, values).getCoefficients();
    }

    private double largestError(DoubleUnaryOperator kernel) {
        double largest = 0;
        for (int tap = 0; tap < taps(); tap++) {
            for (int i = 0; i <= CHECKED; i++) {
                double x = 2.0 * i / CHECKED - 1;
                // The kernel may be discontinuous at its edge.
                double exact = kernel.applyAsDouble(distance(taps(), tap, x * (1 - 1e-12)));
                largest = Math.max(largest, Math.abs(weight(tap, x) - exact));
            }
        }
        return largest;
    }

    /** Returns the weight of a tap at x in [-1, 1]. */
    double weight(int tap, double x) {
        double sum = 0;
        for (int power = powers() - 1; power >= 0; power--) {
            sum = sum * x + coefficients[tap][power];
        }
        return sum;
    }

    double coefficient(int tap, int power) {
        return coefficients[tap][power];
    }

    int taps() {
        return coefficients.length;
    }

    int powers() {
        return coefficients[0].length;
    }

    /** Defines TAPS, and KERNEL_AT_PLACE, an array of the weights at the variable place, by Horner's rule. */
    public void defineIn(ShaderTables.Builder tables) {
        StringJoiner weights = new StringJoiner(", ", "float[](", ")");
        for (double[] tap : coefficients) {
            StringBuilder weight = new StringBuilder(literal(tap[powers() - 1]));
            for (int power = powers() - 2; power >= 0; power--) {
                weight.insert(0, "(").append(") * place + ").append(literal(tap[power]));
            }
            weights.add(weight);
        }
        tables.define("TAPS", taps()).define("KERNEL_AT_PLACE", weights);
    }

    private static String literal(double coefficient) {
        return Text.format("(%.9e)", coefficient);
    }
}
