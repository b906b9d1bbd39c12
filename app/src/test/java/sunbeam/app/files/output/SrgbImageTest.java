package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

final class SrgbImageTest {
    @Test
    void theFirstRowIsTheTop() {
        BufferedImage image = SrgbImage.fromArgb(1, 2, new int[] {0xffff0000, 0xff0000ff});
        assertThat(image.getRGB(0, 0)).isEqualTo(0xffff0000);
        assertThat(image.getRGB(0, 1)).isEqualTo(0xff0000ff);
    }

    @Test
    void onlyPicturesWithHolesHaveAlpha() {
        assertThat(SrgbImage.fromArgb(1, 1, new int[] {0xff102030}).getType()).isEqualTo(BufferedImage.TYPE_INT_RGB);
        assertThat(SrgbImage.fromArgb(2, 1, new int[] {0xff102030, 0}).getRGB(1, 0))
                .isZero();
    }

    @Test
    void aLengthThatDoesNotFitIsRefused() {
        assertThatThrownBy(() -> SrgbImage.fromArgb(2, 2, new int[11]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("2 x 2");
    }
}
