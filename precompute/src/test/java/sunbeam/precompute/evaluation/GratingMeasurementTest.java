package sunbeam.precompute.evaluation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.table.PatchIdentity;

final class GratingMeasurementTest {
    private static final CoherenceWindow WINDOW =
            CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);
    private static final double SIGMA = WINDOW.sigmaFrequency();
    // An order's top is drawn aside by the slope of its strength over frequency: sigma_f^2 / (2 f) d ln power / d f,
    // about (sigma_f d)^2 = 3e-4 at 1.7 um and 6e-4 at 2.5 um, relative.
    private static final double PULL = 6e-4;

    private static double[] steps(double first, double last, int count) {
        double[] values = new double[count];
        Arrays.setAll(values, i -> first + (last - first) * i / (count - 1));
        return values;
    }

    private static GratingMeasurement measure(HeightMap map, GratingPlane plane, FirstOrder order, int angles) {
        double[] ends = order.angles(plane, 380e-9, 780e-9);
        ResponseGrid grid = new ResponseGrid(plane, steps(380e-9, 780e-9, 21), steps(ends[0], ends[1], angles));
        PatchIdentity identity =
                new PatchIdentity("test", map.columns(), map.rows(), map.pitchX(), map.pitchY(), "digest");
        ResponseMatrix response = BinSums.of(identity, HeightLevels.of(map), WINDOW, grid)
                .coherent(List.of(new WindowPlace(0, 0)), row -> {})
                .get(0);
        return GratingMeasurement.of(response, order, SIGMA).orElseThrow();
    }

    private static GratingPlane light(double theta, double phi, double azimuth) {
        return new GratingPlane(Math.toRadians(theta), Math.toRadians(phi), Math.toRadians(azimuth));
    }

    @Test
    void aSineHasItsPeriodInEveryLight() {
        HeightMap map = Surfaces.of(34, 1, 50e-9, (x, y) -> 60e-9 * Math.sin(2 * Math.PI * x / 1.7e-6));
        for (GratingPlane plane : List.of(light(75, 0, 0), light(75, 180, 0), light(0, 0, 0), light(40, 35, 0))) {
            GratingMeasurement found = measure(map, plane, FirstOrder.around(1.7e-6, 1.2), 800);
            assertThat(found.interpolated().mean()).as(plane.toString()).isCloseTo(1.7e-6, within(PULL * 1.7e-6));
            assertThat(found.interpolated().count()).isEqualTo(21);
        }
    }

    @Test
    void anObliqueGratingIsMeasuredAlongItsAzimuth() {
        // 4 waves along x and 3 along y of 10 um: period 2 um, direction atan(3/4).
        HeightMap map =
                Surfaces.of(100, 100, 100e-9, (x, y) -> 50e-9 * Math.cos(2 * Math.PI * (4 * x + 3 * y) / 10e-6));
        double azimuth = Math.toDegrees(Math.atan2(3, 4));
        GratingMeasurement found = measure(map, light(75, 0, azimuth), FirstOrder.around(2e-6, 1.2), 600);
        assertThat(found.interpolated().mean()).isCloseTo(2e-6, within(PULL * 2e-6));
    }

    @Test
    void blazedLightIsFollowedOnItsBrightSide() {
        // Rising towards +x, lit from the normal: the bright order lies towards -x, at negative angles and u =
        // +lambda/d.
        HeightMap map = Surfaces.of(100, 1, 25e-9, (x, y) -> 0.1 * x);
        GratingMeasurement found = measure(map, light(0, 0, 0), FirstOrder.around(2.5e-6, 1.2), 1500);
        assertThat(found.order()).isEqualTo(1);
        assertThat(Arrays.stream(found.ridge().peakAngles())).allMatch(angle -> angle < 0);
        assertThat(found.interpolated().mean()).isCloseTo(2.5e-6, within(PULL * 2.5e-6));
    }

    @Test
    void peaksBetweenSamplesScatterLessThanPeaksOnSamples() {
        HeightMap map = Surfaces.of(34, 1, 50e-9, (x, y) -> 60e-9 * Math.sin(2 * Math.PI * x / 1.7e-6));
        GratingMeasurement coarse = measure(map, light(75, 0, 0), FirstOrder.around(1.7e-6, 1.2), 200);
        assertThat(coarse.interpolated().variance())
                .isLessThan(0.1 * coarse.sampled().variance());
        // Coarse samples still give the mean, to four of their standard errors.
        assertThat(coarse.sampled().mean())
                .isCloseTo(
                        coarse.interpolated().mean(),
                        within(4 * coarse.sampled().standardError()));
    }

    @Test
    void theStrongerOfTwoRegularitiesIsMeasured() {
        HeightMap map = Surfaces.of(
                260,
                1,
                50e-9,
                (x, y) -> 50e-9 * Math.sin(2 * Math.PI * x / 1.3e-6) + 25e-9 * Math.sin(2 * Math.PI * x / 1.625e-6));
        GratingMeasurement found = measure(map, light(75, 0, 0), FirstOrder.around(1.4e-6, 1.35), 800);
        assertThat(found.interpolated().mean()).isCloseTo(1.3e-6, within(PULL * 1.3e-6));
        // The spread over wavelengths is the pull's, not that of a curve that jumps over to the other by 300 nm.
        assertThat(found.interpolated().variance()).isLessThan(1e-18);
        // Seen beside it; its place among the candidates is read off the search's steps.
        assertThat(found.candidates().get(1).period()).isCloseTo(1.625e-6, within(3e-9));
    }

    /** A response with ridges of Gaussian shape, whose strengths are functions of ridge and wavelength. */
    private static ResponseMatrix ridges(double[] periods, DoubleBinaryOperator strength) {
        GratingPlane plane = light(75, 0, 0);
        ResponseGrid grid = new ResponseGrid(plane, steps(380e-9, 780e-9, 81), steps(-0.9, 0, 1000));
        double[][] values = new double[81][1000];
        for (int i = 0; i < 81; i++) {
            for (int j = 0; j < 1000; j++) {
                values[i][j] = 1e-9;
                double frequency = plane.u(grid.angles()[j]) / grid.wavelengths()[i];
                for (int ridge = 0; ridge < periods.length; ridge++) {
                    double distance = (frequency + 1 / periods[ridge]) / SIGMA;
                    values[i][j] +=
                            strength.applyAsDouble(ridge, grid.wavelengths()[i]) * Math.exp(-distance * distance);
                }
            }
        }
        return new ResponseMatrix(grid, values);
    }

    @Test
    void aBrighterRidgeAtSomeWavelengthsDoesNotCaptureTheCurve() {
        double[] periods = {1.2e-6, 1.05e-6};
        // The second is a hundred times brighter around 500 nm, and absent elsewhere.
        ResponseMatrix response = ridges(
                periods,
                (ridge, wavelength) ->
                        ridge == 0 ? 1 : 100 * Math.exp(-0.5 * Math.pow((wavelength - 500e-9) / 20e-9, 2)));
        Ridge followed = new RidgeTracker(response, SIGMA).follow(-1 / 1.2e-6);
        assertThat(followed.size()).isEqualTo(81);
        // The parabola is exact for a Gaussian in u, and angles are even only locally.
        assertThat(Arrays.stream(followed.periods())).allMatch(period -> Math.abs(period - 1.2e-6) < 0.5e-9);
    }

    @Test
    void aRidgeThatFadesIsFollowedWhereItIs() {
        ResponseMatrix response = ridges(
                new double[] {1.2e-6}, (ridge, wavelength) -> wavelength > 502e-9 && wavelength < 548e-9 ? 0 : 1);
        Ridge followed = new RidgeTracker(response, SIGMA).follow(-1 / 1.2e-6);
        assertThat(followed.size()).isEqualTo(81 - 9);
        assertThat(PeriodStatistics.of(followed.periods()).mean()).isCloseTo(1.2e-6, within(0.1e-9));
    }

    @Test
    void anEvenResponseHasNoRidge() {
        ResponseMatrix response = ridges(new double[0], (ridge, wavelength) -> 0);
        assertThat(GratingMeasurement.of(response, FirstOrder.around(1.2e-6, 1.3), SIGMA))
                .isEmpty();
    }

    @Test
    void anOrderBelowTheHorizonHasNoAngles() {
        assertThat(FirstOrder.around(150e-9, 1.1).angles(light(75, 0, 0), 380e-9, 780e-9))
                .isEmpty();
    }

    @Test
    void statisticsAreTheTextbooks() {
        PeriodStatistics statistics = PeriodStatistics.of(new double[] {1, 2, 3, 4});
        assertThat(statistics.mean()).isEqualTo(2.5);
        assertThat(statistics.variance()).isCloseTo(5.0 / 3, within(1e-15));
        assertThat(statistics.standardError()).isCloseTo(Math.sqrt(5.0 / 12), within(1e-15));
        assertThatThrownBy(() -> PeriodStatistics.of(new double[] {1})).isInstanceOf(IllegalArgumentException.class);
    }
}
