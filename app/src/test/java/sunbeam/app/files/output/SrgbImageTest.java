package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

final class SrgbImageTest {
    @Test
    void encodedValuesAreOnlyRounded() {
        BufferedImage image = SrgbImage.fromEncoded(1, 1, new float[] {0.2f, 128 / 255f, 0.999f});
        assertThat(image.getRGB(0, 0)).isEqualTo(0xff3380ff);
    }

    @Test
    void valuesBeyondTheDisplayAreClipped() {
        BufferedImage image = SrgbImage.fromEncoded(1, 1, new float[] {-1, 7, Float.POSITIVE_INFINITY});
        assertThat(image.getRGB(0, 0)).isEqualTo(0xff00ffff);
    }

    @Test
    void noColourIsTransparent() {
        BufferedImage image = SrgbImage.fromEncoded(2, 1, new float[] {1, 1, 1, Float.NaN, 1, 1});
        assertThat(image.getRGB(0, 0)).isEqualTo(0xffffffff);
        assertThat(image.getRGB(1, 0)).isZero();
    }

    @Test
    void theFirstRowIsTheTop() {
        BufferedImage image = SrgbImage.fromEncoded(1, 2, new float[] {1, 0, 0, 0, 0, 1});
        assertThat(image.getRGB(0, 0)).isEqualTo(0xffff0000);
        assertThat(image.getRGB(0, 1)).isEqualTo(0xff0000ff);
    }

    @Test
    void aLengthThatDoesNotFitIsRefused() {
        assertThatThrownBy(() -> SrgbImage.fromEncoded(2, 2, new float[11]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("2 x 2");
    }
}
