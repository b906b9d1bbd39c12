package sunbeam.app.gpu.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The definition: of the pixels brighter than 1e-3 of the brightest, 97 % come out at 0.85 of white or below. */
class AutoExposureTest {
    private static final double WHITE = 0.85;
    // Luminances are float32.
    private static final double ROUNDING = 1e-6;

    private static LinearPicture picture(double... luminances) {
        float[] xyz = new float[3 * luminances.length];
        for (int i = 0; i < luminances.length; i++) {
            // X and Z differ from pixel to pixel; they must not count.
            xyz[3 * i] = (float) (luminances[i] * (i % 7));
            xyz[3 * i + 1] = (float) luminances[i];
            xyz[3 * i + 2] = (float) (luminances[i] * (i % 3) - 5);
        }
        return new LinearPicture(luminances.length, 1, xyz);
    }

    private static double exposure(double... luminances) {
        return AutoExposure.of(picture(luminances), pixel -> false);
    }

    /** Spread over two decades, as diffracted light is, in no order. */
    private static double[] diffraction(int pixels) {
        return new Random(5).doubles(pixels, -2, 0).map(x -> Math.pow(10, x)).toArray();
    }

    private static double[] joined(double[] first, double... more) {
        double[] all = Arrays.copyOf(first, first.length + more.length);
        System.arraycopy(more, 0, all, first.length, more.length);
        return all;
    }

    private static double[] repeated(int times, double value) {
        double[] all = new double[times];
        Arrays.fill(all, value);
        return all;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-30, 1e-6, 0.7, 3e5, 1e30})
    void anEvenPictureIsDrawnJustBelowWhite(double luminance) {
        assertThat(exposure(repeated(50, luminance)) * luminance).isCloseTo(WHITE, within(ROUNDING));
        assertThat(exposure(luminance) * luminance).as("one pixel").isCloseTo(WHITE, within(ROUNDING));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 33, 34, 101, 5000})
    void ninetySevenPercentComeOutBelowWhiteAndNoneTooMany(int pixels) {
        double[] luminances = diffraction(pixels);

        double exposure = exposure(luminances);

        long below = Arrays.stream(luminances)
                .filter(y -> exposure * y < WHITE * (1 - ROUNDING))
                .count();
        long upTo = Arrays.stream(luminances)
                .filter(y -> exposure * y <= WHITE * (1 + ROUNDING))
                .count();
        assertThat(upTo - below).as("the pixel that is drawn just below white").isEqualTo(1);
        // The pixel of rank 0.97 of the way from the darkest to the brightest, the lower one where it lies between two.
        assertThat((double) below).isLessThanOrEqualTo(0.97 * (pixels - 1));
        assertThat((double) upTo).isGreaterThan(0.97 * (pixels - 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-12, 0.25, 1e9})
    void brighterLightIsExposedLessInProportion(double factor) {
        double[] luminances = diffraction(400);
        double[] brighter = Arrays.stream(luminances).map(y -> factor * y).toArray();

        assertThat(factor * exposure(brighter) / exposure(luminances)).isCloseTo(1, within(ROUNDING));
    }

    @Test
    void smallChangesOfTheLightChangeItLittle() {
        double[] luminances = diffraction(400);
        Random random = new Random(9);
        double[] changed = Arrays.stream(luminances)
                .map(y -> y * (1 + 1e-3 * (2 * random.nextDouble() - 1)))
                .toArray();

        // A rank's value moves by no more than the values do.
        assertThat(exposure(changed) / exposure(luminances)).isBetween(1 - 1.01e-3, 1 + 1.01e-3);
    }

    @Test
    void theBlackBackgroundDoesNotCount() {
        double[] luminances = diffraction(400);
        double brightest = Arrays.stream(luminances).max().orElseThrow();
        double[] onBlack = joined(joined(luminances, repeated(9000, 0)), repeated(500, 0.9e-3 * brightest));
        double[] onGrey = joined(luminances, repeated(9000, 1.1e-3 * brightest));

        assertThat(exposure(onBlack)).isEqualTo(exposure(luminances));
        assertThat(exposure(onGrey)).as("dark, but lit").isGreaterThan(2 * exposure(luminances));
    }

    @Test
    void theSpecularPeakDoesNotCount() {
        double[] luminances = diffraction(400);
        double[] withPeak = joined(luminances, 1e5, 2e5, 3e5);

        assertThat(AutoExposure.of(picture(withPeak), pixel -> pixel >= 400)).isEqualTo(exposure(luminances));
        assertThat(AutoExposure.of(picture(withPeak), pixel -> true))
                .as("nothing else")
                .isEqualTo(1);
    }

    @Test
    void aGlintBurnsOutUntilAllElseIsBackgroundBesideIt() {
        double[] surface = repeated(400, 0.2);

        assertThat(exposure(joined(surface, 100))).isEqualTo(exposure(surface));
        // A thousand times the rest: that is how a lone order on black looks, which must not be drawn as white.
        assertThat(exposure(joined(surface, 1000)) * 1000).isCloseTo(WHITE, within(ROUNDING));
    }

    @Test
    void withoutLightItIsOne() {
        assertThat(exposure(repeated(20, 0))).as("black").isEqualTo(1);
        assertThat(exposure(repeated(20, Double.NaN))).as("no surface").isEqualTo(1);
        assertThat(exposure(repeated(20, -1e-9))).as("rounded below zero").isEqualTo(1);
        assertThat(exposure()).as("no pixel").isEqualTo(1);
    }

    @Test
    void pixelsThatAreNoNumbersDoNotCount() {
        double[] luminances = diffraction(400);

        assertThat(exposure(joined(luminances, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -3)))
                .isEqualTo(exposure(luminances));
    }
}
