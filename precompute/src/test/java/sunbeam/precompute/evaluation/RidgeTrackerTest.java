package sunbeam.precompute.evaluation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.evaluation.GratingPlane.FirstOrder;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.evaluation.Ridge.Peaks;
import sunbeam.precompute.evaluation.Ridge.RidgeTracker;
import sunbeam.precompute.optics.CoherenceWindow;

/** Responses with ridges of Gaussian shape, as the orders of a grating have under a Gaussian window. */
final class RidgeTrackerTest {
    private static final double SIGMA = CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH)
            .sigmaFrequency();
    private static final double SHORTEST = 380e-9;
    private static final double LONGEST = 780e-9;
    private static final int WAVELENGTHS = 81;

    private static GratingPlane light(double theta, double phi) {
        return new GratingPlane(Math.toRadians(theta), Math.toRadians(phi), 0);
    }

    /** @param strength of a period, numbered, at a wavelength, meters */
    private static ResponseMatrix ridges(
            GratingPlane plane, FirstOrder order, double[] frequencies, DoubleBinaryOperator strength) {
        double[] wavelengths = new double[WAVELENGTHS];
        Arrays.setAll(wavelengths, i -> SHORTEST + (LONGEST - SHORTEST) * i / (WAVELENGTHS - 1));
        double[] angles = order.angles(plane, SHORTEST, LONGEST, 1000).orElseThrow();
        double[][] values = new double[WAVELENGTHS][angles.length];
        for (int i = 0; i < WAVELENGTHS; i++) {
            for (int j = 0; j < angles.length; j++) {
                values[i][j] = 1e-9;
                double frequency = plane.u(angles[j]) / wavelengths[i];
                for (int ridge = 0; ridge < frequencies.length; ridge++) {
                    double distance = (frequency - frequencies[ridge]) / SIGMA;
                    values[i][j] += strength.applyAsDouble(ridge, wavelengths[i]) * Math.exp(-distance * distance);
                }
            }
        }
        return new ResponseMatrix(new ResponseGrid(plane, wavelengths, angles), values);
    }

    private static Optional<Ridge> follow(
            GratingPlane plane, FirstOrder order, double[] frequencies, DoubleBinaryOperator strength) {
        return new RidgeTracker(ridges(plane, order, frequencies, strength), SIGMA).follow(order);
    }

    /** The parabola is exact for a Gaussian in u; angles are linear in u only locally. */
    @ParameterizedTest
    @CsvSource({"75, 0, -1", "75, 180, 1", "0, 0, 1", "0, 0, -1", "40, 35, -1"})
    void aRidgeHasItsPeriodAndItsSideInEveryLight(double theta, double phi, int side) {
        Ridge ridge = follow(
                        light(theta, phi),
                        FirstOrder.around(1.75e-6, 1.2),
                        new double[] {side / 1.7e-6},
                        (each, wavelength) -> 1)
                .orElseThrow();
        assertThat(ridge.order()).isEqualTo(-side);
        assertThat(ridge.wavelengths()).hasSize(WAVELENGTHS);
        assertThat(Arrays.stream(ridge.periods())).allMatch(period -> Math.abs(period - 1.7e-6) < 0.5e-9);
    }

    @Test
    void aBrighterRidgeAtSomeWavelengthsDoesNotCaptureTheCurve() {
        double[] frequencies = {-1 / 1.2e-6, -1 / 1.05e-6};
        // The second is a hundred times brighter around 500 nm, and absent elsewhere.
        DoubleBinaryOperator strength =
                (each, wavelength) -> each == 0 ? 1 : 100 * Math.exp(-0.5 * Math.pow((wavelength - 500e-9) / 20e-9, 2));
        ResponseMatrix response = ridges(light(75, 0), FirstOrder.around(1.2e-6, 1.35), frequencies, strength);
        Ridge ridge = new RidgeTracker(response, SIGMA).follow(-1 / 1.2e-6).orElseThrow();
        assertThat(ridge.wavelengths()).hasSize(WAVELENGTHS);
        assertThat(Arrays.stream(ridge.periods())).allMatch(period -> Math.abs(period - 1.2e-6) < 0.5e-9);
        // Algorithm 4.1 of the thesis jumps to the second within 20 nm sqrt(2 ln 100), as in its figure 4.9 (b).
        Ridge maxima = Peaks.MAXIMUM
                .of(response, FirstOrder.around(1.2e-6, 1.35), SIGMA)
                .orElseThrow();
        for (int i = 0; i < WAVELENGTHS; i++) {
            boolean second = Math.abs(maxima.wavelengths()[i] - 500e-9) < 60.7e-9;
            // Half a step of the grid's angles, 0.023 degrees, is 1.2 nm of the period at 380 nm.
            assertThat(maxima.periods()[i]).isCloseTo(second ? 1.05e-6 : 1.2e-6, within(1.3e-9));
        }
    }

    /** Algorithm 4.1 divides the range by C, equation 4.3 by C - 1: labels then end at 780 - 400 / 81 nm. */
    @Test
    void maximaByCountAreLabeledInSmallerSteps() {
        FirstOrder order = FirstOrder.around(1.2e-6, 1.35);
        ResponseMatrix response = ridges(light(75, 0), order, new double[] {-1 / 1.2e-6}, (each, wavelength) -> 1);
        Ridge maxima = Peaks.MAXIMUM_BY_COUNT.of(response, order, SIGMA).orElseThrow();
        double last = LONGEST - (LONGEST - SHORTEST) / WAVELENGTHS;
        assertThat(maxima.wavelengths()[0]).isEqualTo(SHORTEST);
        assertThat(maxima.wavelengths()[WAVELENGTHS - 1]).isCloseTo(last, within(1e-15));
        assertThat(maxima.periods()[WAVELENGTHS - 1]).isCloseTo(1.2e-6 * last / LONGEST, within(1.3e-9));
    }

    @Test
    void anEvenResponseHasNoRidge() {
        assertThat(follow(light(75, 0), FirstOrder.around(1.2e-6, 1.3), new double[0], (each, wavelength) -> 0))
                .isEmpty();
    }
}
