package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class InterpolationTest {
    // Float32 coefficients, at most six times as large as the values.
    private static final double ROUNDING = 1e-6;

    /** The spline at a sample: a sixth of each neighbor, mirrored at the ends. */
    private static double at(float[] c, int i) {
        int last = c.length - 1;
        double before = c[i == 0 ? 1 : i - 1];
        double after = c[i == last ? last - 1 : i + 1];
        return (before + 4 * c[i] + after) / 6;
    }

    @ParameterizedTest
    @ValueSource(ints = {11, 17, 100})
    void goesThroughAllSamples(int count) {
        Random random = new Random(count);
        float[] samples = new float[count];
        for (int i = 0; i < count; i++) {
            samples[i] = random.nextFloat();
        }
        float[] coefficients = samples.clone();
        Interpolation.CUBIC.toCoefficients(coefficients, count, 1);
        for (int i = 0; i < count; i++) {
            assertThat(at(coefficients, i)).as("sample %d", i).isCloseTo(samples[i], within(ROUNDING));
        }
    }

    /** Tiles of an older filter of the same name are not taken for those of the present one. */
    @Test
    void keysContainTheFiltersImpulseResponse() {
        for (Interpolation filter : Interpolation.values()) {
            float[] impulse = new float[16];
            impulse[8] = 1;
            filter.toCoefficients(impulse, 16, 1);

            for (float coefficient : impulse) {
                assertThat(filter.key()).contains(String.valueOf(coefficient));
            }
        }
        assertThat(Interpolation.CUBIC.key()).isNotEqualTo(Interpolation.SHIFTED_LINES.key());
    }
}
