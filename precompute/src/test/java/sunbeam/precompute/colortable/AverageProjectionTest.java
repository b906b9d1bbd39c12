package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.util.CombinatoricsUtils;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.colortable.LogPolarConvolution.AverageProjection;

class AverageProjectionTest {
    private static final int LENGTH = 101;
    private static final int PARTS = 1000;

    /** A cubic B-spline, whose integral is 1, of a distance in strides. */
    private static double spline(double distance) {
        double x = Math.abs(distance);
        if (x < 1) {
            return 2.0 / 3 - x * x + x * x * x / 2;
        }
        return x < 2 ? Math.pow(2 - x, 3) / 6 : 0;
    }

    /** By the trapezoid rule, whose error falls with the fourth power of its steps here. */
    private static double average(DoubleUnaryOperator function, double middle, int stride) {
        double sum = 0;
        for (int i = -2 * PARTS; i <= 2 * PARTS; i++) {
            double distance = (double) i / PARTS;
            sum += spline(distance) / PARTS * function.applyAsDouble(middle + distance * stride);
        }
        return sum;
    }

    /** Integral of a function with a sequence as weights, by its averages. */
    private static double sum(double[] sequence, DoubleUnaryOperator function, int stride) {
        AverageProjection interpolation = new AverageProjection(stride, sequence.length);
        double[] coefficients = interpolation.coefficients(sequence);
        assertThat(coefficients).hasSize(AverageProjection.knots(stride, sequence.length));
        double sum = 0;
        for (int knot = 0; knot < coefficients.length; knot++) {
            sum += coefficients[knot] * average(function, interpolation.firstMiddle() + knot * stride, stride);
        }
        return sum;
    }

    private static double directSum(double[] sequence, DoubleUnaryOperator function) {
        double sum = 0;
        for (int i = 0; i < sequence.length; i++) {
            sum += sequence[i] * function.applyAsDouble(i);
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 4})
    void anySequenceIntegratesPolynomialsExactly(int stride) {
        double[] sequence = new SplittableRandom(5).doubles(LENGTH).toArray();
        for (int degree = 0; degree <= 11; degree++) {
            double scale = CombinatoricsUtils.binomialCoefficientDouble(11, degree);
            int power = degree;
            DoubleUnaryOperator polynomial = x -> scale * Math.pow((x - 50) / 70, power);
            // The trapezoid rule's error and rounding.
            assertThat(sum(sequence, polynomial, stride)).isCloseTo(directSum(sequence, polynomial), within(1e-7));
        }
    }

    /** Relative error on an order's flank, a billionth of its maximum, beyond the end of a filter. */
    @Test
    void whereLightEndsDarkFlanksStayRight() {
        double[] filter = new double[31];
        Arrays.fill(filter, 1);
        int stride = 3;
        double placesPerWidth = stride / 0.15;
        for (double flank = 0; flank < 4.5; flank += 0.25) {
            double middle = 30 + flank * placesPerWidth;
            DoubleUnaryOperator order = x -> Math.exp(-Math.pow((x - middle) / placesPerWidth, 2));
            double expected = directSum(filter, order);
            // Measured 2.7e-4 of 4e-8, 6e-5 of 3e-7, less elsewhere; tables are made for 1e-3.
            assertThat(sum(filter, order, stride)).isCloseTo(expected, within(5e-4 * expected));
        }
    }
}
