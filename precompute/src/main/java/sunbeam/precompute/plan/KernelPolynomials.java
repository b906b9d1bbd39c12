package sunbeam.precompute.plan;

import java.util.StringJoiner;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.polynomials.PolynomialFunctionLagrangeForm;
import sunbeam.precompute.text.Text;

/**
 * Interpolation kernel as polynomials (shaders/method/grid_tables.glsl): the weight of each tap as a function of x = 2 fraction - 1 in [-1,
 * 1], through the kernel at Chebyshev nodes. Unlike a table's, their float32 rounding is relative to each tap's own weight: on a bright
 * order's skirt the outermost tap reads a sample a thousand times brighter than the result.
 */
public record KernelPolynomials(double[][] coefficients) {
    // A sample a thousand times brighter than the result adds an error of 2e-6, less than the finest tolerance.
    private static final double LARGEST_ERROR = 2e-9;
    // Smooth kernels need fewer coefficients.
    private static final int MOST_POWERS = 16;
    private static final int CHECKED_INTERVALS = 64;

    /** Returns polynomials of the least degree near a kernel of distances in samples, which is smooth up to {@code taps / 2}. */
    public static KernelPolynomials of(int taps, DoubleUnaryOperator kernel) {
        for (int powers = 4; powers <= MOST_POWERS; powers++) {
            int count = powers;
            KernelPolynomials polynomials = new KernelPolynomials(IntStream.range(0, taps)
                    .mapToObj(tap -> through(x -> kernel.applyAsDouble(distance(taps, tap, x)), count))
                    .toArray(double[][]::new));
            if (polynomials.largestError(kernel) <= LARGEST_ERROR) {
                return polynomials;
            }
        }
        throw new IllegalArgumentException("no polynomial of " + MOST_POWERS + " powers is near the kernel");
    }

    private static double distance(int taps, int tap, double x) {
        return (x + 1) / 2 + 0.5 * taps - 1 - tap;
    }

    private static double[] through(DoubleUnaryOperator function, int powers) {
        double[] nodes = IntStream.range(0, powers)
                .mapToDouble(i -> Math.cos(Math.PI * (i + 0.5) / powers))
                .toArray();
        double[] values = IntStream.range(0, powers)
                .mapToDouble(i -> function.applyAsDouble(nodes[i]))
                .toArray();
        return new PolynomialFunctionLagrangeForm(nodes, values).getCoefficients();
    }

    private double largestError(DoubleUnaryOperator kernel) {
        double largest = 0;
        for (int tap = 0; tap < coefficients.length; tap++) {
            for (int i = 0; i <= CHECKED_INTERVALS; i++) {
                double x = 2.0 * i / CHECKED_INTERVALS - 1;
                // The kernel may be discontinuous at its edge.
                double exact = kernel.applyAsDouble(distance(coefficients.length, tap, x * (1 - 1e-12)));
                largest = Math.max(largest, Math.abs(weight(tap, x) - exact));
            }
        }
        return largest;
    }

    double weight(int tap, double x) {
        double sum = 0;
        for (int power = powers() - 1; power >= 0; power--) {
            sum = sum * x + coefficients[tap][power];
        }
        return sum;
    }

    int powers() {
        return coefficients[0].length;
    }

    /** Defines TAPS, and KERNEL_AT_PLACE, an array of the weights by Horner's rule. */
    public void defineIn(ShaderTables.Builder tables) {
        StringJoiner weights = new StringJoiner(", ", "float[](", ")");
        for (double[] tap : coefficients) {
            StringBuilder weight = new StringBuilder(literal(tap[powers() - 1]));
            for (int power = powers() - 2; power >= 0; power--) {
                weight.insert(0, "(").append(") * place + ").append(literal(tap[power]));
            }
            weights.add(weight);
        }
        tables.define("TAPS", coefficients.length).define("KERNEL_AT_PLACE", weights);
    }

    private static String literal(double coefficient) {
        return Text.format("(%.9e)", coefficient);
    }
}
