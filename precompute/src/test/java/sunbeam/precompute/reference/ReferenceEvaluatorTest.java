package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.special.BesselJ;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/** The direct sums against closed forms. */
class ReferenceEvaluatorTest {
    private static final double WAVELENGTH = 550e-9;
    private static final double PERIOD = 2.5e-6;
    private static final CoherenceWindow SUNLIGHT =
            CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);
    // Orders lie 40 sigma_f apart: rounding of the sums alone.
    private static final Offset<Double> ROUNDING = within(1e-12);

    @Test
    void aFlatMirrorReflectsAllAndOnlyIntoTheWindowsGaussian() {
        HeightMap flat = Surfaces.of(20, 10, 0.1e-6, (x, y) -> 3e-6);
        double u = 0.005;
        double ratio = u / WAVELENGTH / SUNLIGHT.sigmaFrequency();

        Power specular = evaluator(flat).powers(pair(0), WAVELENGTH);
        Power beside = evaluator(flat).powers(pair(u), WAVELENGTH);

        assertThat(specular.coherent()).isCloseTo(1, ROUNDING);
        assertThat(specular.ensemble()).isCloseTo(1, ROUNDING);
        // |exp(-f^2 / (2 sigma_f^2))|^2; both averages agree.
        assertThat(beside.coherent()).isCloseTo(Math.exp(-ratio * ratio), ROUNDING);
        assertThat(beside.ensemble()).isCloseTo(Math.exp(-ratio * ratio), ROUNDING);
    }

    @ParameterizedTest
    @ValueSource(ints = {-3, -2, -1, 0, 1, 2, 3})
    void aSinusoidHasBesselsOrders(int order) {
        double amplitude = 100e-9;
        HeightMap sinusoid =
                Surfaces.of(128, 4, PERIOD / 128, (x, y) -> amplitude * Math.sin(2 * Math.PI * x / PERIOD));
        DirectionPair pair = pair(order * WAVELENGTH / PERIOD);
        double phase = 2 * Math.PI / WAVELENGTH * -pair.w() * amplitude;

        Power power = evaluator(sinusoid).powers(pair, WAVELENGTH);

        double expected = Math.pow(BesselJ.value(Math.abs(order), phase), 2);
        assertThat(power.coherent()).isCloseTo(expected, ROUNDING);
        assertThat(power.ensemble()).isCloseTo(expected, ROUNDING);
    }

    /** Sampled: 128 steps make the orders' powers periodic sincs, whose numerator is that of the smooth ramp. */
    @ParameterizedTest
    @CsvSource({"1", "-1", "2", "0"})
    void aRampTowardsPlusXSendsLightTowardsMinusX(int order) {
        int samples = 128;
        double height = 250e-9;
        HeightMap ramp = Surfaces.of(samples, 1, PERIOD / samples, (x, y) -> height * x / PERIOD);
        DirectionPair pair = pair(order * WAVELENGTH / PERIOD);

        double power = evaluator(ramp).powers(pair, WAVELENGTH).coherent();

        double turns = pair.w() * height / WAVELENGTH + order;
        double expected = Math.pow(Math.sin(Math.PI * turns) / (samples * Math.sin(Math.PI * turns / samples)), 2);
        assertThat(power).isCloseTo(expected, ROUNDING);
        if (order == 1) {
            assertThat(pair.wr().x()).isNegative();
            assertThat(power).isGreaterThan(0.9);
        }
    }

    @Test
    void theEnsembleIsTheMeanOverAllPositionsOfTheWindow() {
        int side = 12;
        double pitch = 0.3e-6;
        HeightMap rough = Surfaces.random(side, side, pitch, 200e-9, 7);
        CoherenceWindow narrow = new CoherenceWindow(0.5e-6);
        DirectionPair pair = new DirectionPair(Direction.ofDegrees(20, 40), Direction.ofDegrees(35, 250));

        double sum = 0;
        for (int shift = 0; shift < side * side; shift++) {
            int right = shift % side;
            int down = shift / side;
            double[] heights = new double[side * side];
            for (int i = 0; i < heights.length; i++) {
                heights[i] = rough.at((i % side + right) % side, (i / side + down) % side);
            }
            HeightMap shifted = new HeightMap(side, side, pitch, pitch, heights);
            sum += new ReferenceEvaluator(shifted, narrow, WindowOrigin.CENTRE).coherent(pair, WAVELENGTH);
        }

        double ensemble = new ReferenceEvaluator(rough, narrow, WindowOrigin.CENTRE)
                .powers(pair, WAVELENGTH)
                .ensemble();
        // Window positions are whole samples; the window is 1.7 samples wide, aliased to exp(-2 (pi 1.7)^2).
        assertThat(ensemble).isCloseTo(sum / (side * side), within(1e-9 * ensemble));
    }

    private static ReferenceEvaluator evaluator(HeightMap map) {
        return new ReferenceEvaluator(map, SUNLIGHT, WindowOrigin.CENTRE);
    }

    /** Light along the normal, viewed where u has the value: left of the center if positive. */
    private static DirectionPair pair(double u) {
        return new DirectionPair(new Direction(0, 0, 1), Direction.ofDisc(-u, 0));
    }
}
