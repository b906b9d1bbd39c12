package sunbeam.precompute.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StridedSplineTest {
    private static final int LENGTH = 101;

    /** A cubic B-spline, whose integral is 1, of a distance in strides. */
    private static double spline(double distance) {
        double x = Math.abs(distance);
        if (x < 1) {
            return 2.0 / 3 - x * x + x * x * x / 2;
        }
        return x < 2 ? Math.pow(2 - x, 3) / 6 : 0;
    }

    /** The sum of the B-splines with their coefficients, at places from 0 on. */
    private static double[] sum(StridedSpline splines, int stride, double[] coefficients) {
        double[] sum = new double[LENGTH];
        for (int i = 0; i < LENGTH; i++) {
            for (int knot = 0; knot < coefficients.length; knot++) {
                double middle = splines.firstMiddle() + knot * stride;
                sum[i] += coefficients[knot] * spline((i - middle) / stride) / stride;
            }
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5})
    void smoothSequencesAreSumsOfBSplines(int stride) {
        double[] bell = new double[LENGTH];
        Arrays.setAll(bell, i -> Math.exp(-Math.pow((i - 50) / 12.0, 2)));
        StridedSpline splines = new StridedSpline(stride, LENGTH);
        double[] coefficients = splines.coefficients(bell);
        assertThat(coefficients).hasSize(splines.knots()).hasSize(StridedSpline.knots(stride, LENGTH));
        // A cubic spline errs by 0.0013 times the fourth derivative, 12 at most in units of the bell's width, and the
        // fourth power
        // of 5 / 12.
        assertThat(sum(splines, stride, coefficients)).containsExactly(bell, within(1e-3));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 5})
    void whatIsASumOfBSplinesIsFoundAgain(int stride) {
        StridedSpline splines = new StridedSpline(stride, LENGTH);
        double[] coefficients = new double[splines.knots()];
        double[] random = new SplittableRandom(5).doubles(coefficients.length).toArray();
        // Those in the middle, which do not reach beyond the sequence.
        System.arraycopy(random, 0, coefficients, 6, coefficients.length - 12);
        double[] found = splines.coefficients(sum(splines, stride, coefficients));
        // Rounding, times the condition of the B-splines' scalar products, some hundreds.
        assertThat(found).containsExactly(coefficients, within(1e-11));
    }

    @Test
    void nothingReachesFarBeyondTheEnds() {
        StridedSpline splines = new StridedSpline(4, LENGTH);
        assertThat(splines.firstMiddle() - 2 * 4).isGreaterThanOrEqualTo(-4 * 4);
        assertThat(splines.firstMiddle() + (splines.knots() - 1) * 4 + 2 * 4).isLessThanOrEqualTo(LENGTH - 1 + 4 * 4);
    }
}
