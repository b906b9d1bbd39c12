package sunbeam.precompute.shader;

import java.util.StringJoiner;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.polynomials.PolynomialFunctionLagrangeForm;
import sunbeam.precompute.text.Text;

/**
 * An interpolation kernel as shaders/method/grid_tables.glsl evaluates it: the weight of each tap as a polynomial of the
 * place between two samples, x = 2 fraction - 1 in [-1, 1], through the kernel at Chebyshev's points. Kernels that are
 * smooth where they reach need few powers. Against a table there is nothing to fetch, and float32 rounds in proportion to the
 * tap's own weights: on the skirt of a bright order, the outermost tap meets a sample that is a thousand times brighter than
 * what it is for.
 */
public record KernelPolynomials(double[][] coefficients) {
    // What is left out of a kernel whose peak is 1: on a skirt a thousand times that is less than float32 rounds
    // elsewhere.
    private static final double ERROR = 2e-9;
    private static final int MOST_POWERS = 16;
    private static final int CHECKED = 64;

    /**
     * The fewest powers that serve, the same of all taps.
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
                // At its very edge a kernel may be cut off.
                double exact = kernel.applyAsDouble(distance(taps(), tap, x * (1 - 1e-12)));
                largest = Math.max(largest, Math.abs(weight(tap, x) - exact));
            }
        }
        return largest;
    }

    /** Weight of a tap at x in [-1, 1] between two samples. */
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

    /** TAPS, and KERNEL_AT_PLACE, an array of their weights at the variable place, by Horner's rule. */
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
