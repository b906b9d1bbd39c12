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

    /** Smooth, and nothing at its ends, as colour matching functions are. */
    private static double[] bell() {
        double[] bell = new double[LENGTH];
        Arrays.setAll(bell, i -> Math.exp(-Math.pow((i - 50) / 12.0, 2)));
        return bell;
    }

    @Test
    void withAStrideOfOneCoefficientsAreTheSequence() {
        double[] sequence = new SplittableRandom(5).doubles(LENGTH).toArray();
        StridedSpline spline = new StridedSpline(1, LENGTH);
        assertThat(spline.knots()).isEqualTo(LENGTH);
        assertThat(spline.first()).isZero();
        assertThat(spline.last()).isEqualTo(LENGTH - 1);
        assertThat(spline.coefficients(sequence)).containsExactly(sequence, within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void convolvesAsTheSequenceDoes(int stride) {
        double[] bell = bell();
        StridedSpline spline = new StridedSpline(stride, LENGTH);
        double[] coefficients = spline.coefficients(bell);
        int places = 20;
        double[] values = new SplittableRandom(6)
                .doubles(spline.read(places + spline.knots() - 1))
                .toArray();
        double[] smoothed = new double[places + spline.knots() + 7];
        spline.smooth(values, smoothed, places + spline.knots() - 1);
        for (int place = 0; place < places; place++) {
            double sum = 0;
            for (int knot = 0; knot < spline.knots(); knot++) {
                sum += coefficients[knot] * smoothed[place + spline.knots() - 1 - knot];
            }
            double exact = 0;
            for (int i = 0; i < LENGTH; i++) {
                exact += bell[i] * values[place * stride + spline.last() - i];
            }
            // The bell's integral is 21; a cubic spline errs by the fourth power of 5 / 12, divided by some hundreds.
            assertThat(sum).isCloseTo(exact, within(21 * 2e-4));
        }
        assertThat(smoothed[places + spline.knots()]).isZero();
    }

    @Test
    void nothingReachesFarBeyondTheEnds() {
        StridedSpline spline = new StridedSpline(4, LENGTH);
        assertThat(spline.first()).isGreaterThanOrEqualTo(-12);
        assertThat(spline.last()).isLessThanOrEqualTo(LENGTH - 1 + 12);
    }
}
