package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;

class CachedExposureTest {
    private static final int SIDE = 80;
    private static final int BACKGROUND = 0x101418;

    /** Returns a picture with grays of three decades on one half, nothing on the other. */
    private static LinearPicture picture() {
        SplittableRandom random = new SplittableRandom(7);
        float[] xyz = new float[3 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            double luminance = Math.pow(10, 3 * random.nextDouble() - 2);
            xyz[3 * i] = i % 2 == 0 ? Float.NaN : (float) (0.95047 * luminance);
            xyz[3 * i + 1] = i % 2 == 0 ? Float.NaN : (float) luminance;
            xyz[3 * i + 2] = i % 2 == 0 ? Float.NaN : (float) (1.08883 * luminance);
        }
        return new LinearPicture(SIDE, SIDE, xyz);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.1, 0.3})
    void itIsThatOfTheLightThatIsShown(double exposure) {
        DisplayTransform display = new DisplayTransform(exposure, Tone.COMPRESS);
        BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        image.createGraphics().drawImage(picture().shown(display), 0, 0, null);
        for (int i = 0; i < SIDE * SIDE; i += 2) {
            image.setRGB(i % SIDE, Math.floorDiv(i, SIDE), BACKGROUND);
        }
        // Half a step of 8 bits is 2 % of the light of a pixel ten times as bright as white, which is compressed.
        double exact = LinearPicture.exposure(picture());
        assertThat(CachedExposure.onScreen(image, display, BACKGROUND)).isCloseTo(exact, within(0.02 * exact));
    }
}
