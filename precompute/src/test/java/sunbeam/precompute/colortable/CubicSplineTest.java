package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CubicSplineTest {
    // Coefficients are rounded to float32, and six times as large as what they make up at most.
    private static final double ROUNDING = 1e-6;

    /** The spline at a sample: neighbors count a sixth each; at an end the mirror gives the missing one. */
    private static double at(float[] c, int i) {
        int last = c.length - 1;
        double before = c[i == 0 ? 1 : i - 1];
        double after = c[i == last ? last - 1 : i + 1];
        return (before + 4 * c[i] + after) / 6;
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 5, 17, 100})
    void goesThroughAllSamples(int count) {
        Random random = new Random(count);
        float[] samples = new float[count];
        for (int i = 0; i < count; i++) {
            samples[i] = random.nextFloat();
        }
        float[] coefficients = samples.clone();
        CubicSpline.toCoefficients(coefficients, 0, 1, count);
        for (int i = 0; i < count; i++) {
            assertThat(at(coefficients, i)).as("sample %d", i).isCloseTo(samples[i], within(ROUNDING));
        }
    }

    @Test
    void whatOneSampleCountsFallsByTheSameFactorASample() {
        float[] peak = new float[41];
        peak[20] = 1;
        CubicSpline.toCoefficients(peak, 0, 1, peak.length);
        for (int i = 21; i < 30; i++) {
            assertThat(peak[i] / peak[i - 1]).isCloseTo((float) CubicSpline.POLE, within(1e-4f));
        }
    }

    @Test
    void filtersColumnsInPlaceAndNothingBesideThem() {
        float[] plane = {1, 9, 2, 9, 4, 9, 8, 9};
        float[] column = {1, 2, 4, 8};
        CubicSpline.toCoefficients(plane, 0, 2, 4);
        CubicSpline.toCoefficients(column, 0, 1, 4);
        assertThat(plane).containsExactly(column[0], 9, column[1], 9, column[2], 9, column[3], 9);
    }

    @Test
    void aSingleSampleIsItsOwnCoefficient() {
        float[] single = {3};
        CubicSpline.toCoefficients(single, 0, 1, 1);
        CubicSpline.toCoefficients(single, 0, 1, 0);
        assertThat(single).containsExactly(3);
    }

    @ParameterizedTest
    @ValueSource(ints = {9, 10, 34})
    void allColumnsTogetherAreThoseOneByOne(int rows) {
        Random random = new Random(rows);
        int columns = 7;
        float[] together = new float[rows * columns];
        for (int i = 0; i < together.length; i++) {
            // Of very different sizes, as roots of colors are beside the specular peak.
            together[i] = (float) Math.exp(-12 * random.nextDouble());
        }
        float[] oneByOne = together.clone();
        CubicSpline.alongColumns(together, rows, columns);
        for (int column = 0; column < columns; column++) {
            CubicSpline.toCoefficients(oneByOne, column, columns, rows);
        }
        for (int i = 0; i < together.length; i++) {
            assertThat(together[i]).isCloseTo(oneByOne[i], within((float) ROUNDING));
        }
    }
}
