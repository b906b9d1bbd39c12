package sunbeam.app.gpu.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What an automatic exposure must do whatever its formula: light what is there, and never jump (docs/theory.md). */
class AutoExposureTest {
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
        return AutoExposure.of(picture(luminances));
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
    void anEvenPictureIsDrawnAtTheTarget(double luminance) {
        assertThat(exposure(repeated(50, luminance)) * luminance)
                .isCloseTo(AutoExposure.TARGET, within(AutoExposure.TARGET * ROUNDING));
        assertThat(exposure(luminance) * luminance)
                .as("one pixel")
                .isCloseTo(AutoExposure.TARGET, within(AutoExposure.TARGET * ROUNDING));
    }

    @Test
    void itIsThatOfTheUpperPartOfThePicture() {
        double[] luminances = diffraction(5000);
        double[] sorted = Arrays.stream(luminances).sorted().toArray();

        double well = AutoExposure.TARGET / exposure(luminances);

        // Half of the lightness lies below this rank of a distribution that is even in log Y: the share of lightness
        // below
        // rank r is (100^(r/3) - 1) / (100^(1/3) - 1).
        assertThat(well).isBetween(sorted[(int) (0.67 * 5000)], sorted[(int) (0.98 * 5000)]);
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

        // No luminance moves by more than 1e-3, weights by a third of that, which shifts the band by as much.
        assertThat(exposure(changed) / exposure(luminances)).isBetween(1 - 2e-3, 1 + 2e-3);
    }

    @Test
    void blackCountsNothingAndNearlyBlackNearlyNothing() {
        double[] luminances = diffraction(400);

        assertThat(exposure(joined(luminances, repeated(9000, 0)))).isEqualTo(exposure(luminances));
        // Lightness 9000 (1e-12)^(1/3) beside some 100.
        assertThat(exposure(joined(luminances, repeated(9000, 1e-12))) / exposure(luminances))
                .isCloseTo(1, within(1e-2));
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 1e3, 1e4, 1e5})
    void aGlintLeavesGreyGrey(double times) {
        double[] surface = repeated(2500, 0.2);
        double without = exposure(surface);

        // It holds this share of the lightness that counts, where the logarithm differs by log(times).
        double share = Math.cbrt(times) / (0.5 * (2500 + Math.cbrt(times)));
        assertThat(exposure(joined(surface, 0.2 * times)) / without)
                .isBetween(Math.exp(-1.01 * share * Math.log(times)), 1.0);
    }

    @Test
    void aLoneOrderOnBlackIsDrawnAtTheTarget() {
        // 0.5 % of the picture, over a ground 1e9 times darker.
        double[] order = repeated(50, 0.1);

        assertThat(exposure(joined(order, repeated(9950, 1e-10))) * 0.1).isCloseTo(AutoExposure.TARGET, within(0.01));
    }

    /** From no glints at all to nothing else: at no step may the picture turn from grey to black. */
    @ParameterizedTest
    @ValueSource(doubles = {1e1, 1e3, 1e5})
    void itFollowsWithoutJumpsAsGlintsSpread(double times) {
        int pixels = 4000;
        double[] picture = repeated(pixels, 0.2);
        double before = exposure(picture);
        for (int bright = 0; bright < pixels; bright++) {
            picture[bright] = 0.2 * times;
            double now = exposure(picture);
            // One more pixel holds at most cbrt(times) / pixels of the lightness, of which half counts, and there the
            // logarithm differs by log(times); the bound between the halves moves as far.
            double mostStep = 2 * Math.cbrt(times) / pixels / 0.5 * Math.log(times);
            assertThat(Math.log(before / now)).isBetween(-1e-9, mostStep);
            before = now;
        }
        assertThat(before * 0.2 * times).isCloseTo(AutoExposure.TARGET, within(ROUNDING));
    }

    @Test
    void ofSeveralPicturesItIsThatOfAllTheirPixels() {
        double[] one = diffraction(400);
        double[] other = repeated(100, 3);

        assertThat(AutoExposure.of(picture(one), picture(other))).isEqualTo(exposure(joined(one, other)));
    }

    @Test
    void withoutLightItIsOne() {
        assertThat(exposure(repeated(20, 0))).as("black").isEqualTo(1);
        assertThat(exposure(repeated(20, Double.NaN))).as("no surface").isEqualTo(1);
        assertThat(exposure(repeated(20, -1e-9))).as("rounded below zero").isEqualTo(1);
        assertThat(exposure()).as("no pixel").isEqualTo(1);
        assertThat(AutoExposure.of()).as("no picture").isEqualTo(1);
    }

    @Test
    void pixelsThatAreNoNumbersDoNotCount() {
        double[] luminances = diffraction(400);

        assertThat(exposure(joined(luminances, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -3)))
                .isEqualTo(exposure(luminances));
    }
}
