package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.reference.AxisWeights.Axis;

class AxisWeightsTest {
    private static final double REACH = 9;

    /** Windows narrower than the patch, as wide, and wider; both ends and the middle as origin; both signs of y. */
    @ParameterizedTest
    @CsvSource({
        "64, 1e-7, 32, 3e-7, 2.0e6",
        "64, -1e-7, 0, 3e-7, -2.0e6",
        "37, 1e-7, 18, 4e-6, 1.3e6",
        "37, -1e-7, 36, 4e-6, 5.1e6",
        "16, 1.5e-7, 8, 16.25e-6, 5.2e6",
        "1, 2e-7, 0, 1e-6, 4.9e6"
    })
    void foldedReplicasAreTheSumOverEverySampleUnderTheWindow(
            int count, double step, int origin, double sigma, double frequency) {
        Axis axis = new Axis(count, step, origin);
        AxisWeights folded = AxisWeights.ofWindow(frequency, axis, axis.window(sigma, REACH));

        double[][] expected = sampleBySample(count, step, origin, sigma, frequency);

        for (int i = 0; i < count; i++) {
            // Weights sum to at most 1; the phase of the farthest sample, 2e3 radians, has a rounding of 2e3 * 2^-53.
            assertThat(folded.real()[i]).as("sample %d", i).isCloseTo(expected[0][i], within(1e-13));
            assertThat(folded.imaginary()[i]).as("sample %d", i).isCloseTo(expected[1][i], within(1e-13));
        }
    }

    private static double[][] sampleBySample(int count, double step, int origin, double sigma, double frequency) {
        double[][] weights = new double[2][count];
        double total = 0;
        int extent = (int) Math.floor(REACH * sigma / Math.abs(step));
        for (int offset = -extent; offset <= extent; offset++) {
            double position = offset * step;
            double gauss = Math.exp(-position * position / (2 * sigma * sigma));
            int sample = Math.floorMod(origin + offset, count);
            weights[0][sample] += gauss * Math.cos(2 * Math.PI * frequency * position);
            weights[1][sample] += gauss * Math.sin(2 * Math.PI * frequency * position);
            total += gauss;
        }
        for (int i = 0; i < count; i++) {
            weights[0][i] /= total;
            weights[1][i] /= total;
        }
        return weights;
    }
}
