package sunbeam.app.scene.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.input.InputException;

class BodyTexturesTest {
    @TempDir
    private Path folder;

    private static int channel(BodyTexture texture, int x, int y, int c) {
        return texture.rgba()[4 * (y * texture.width() + x) + c] & 0xff;
    }

    @Test
    void grayPicturesAreAsBrightAsColoredOnesOfTheSameNumbers() throws IOException {
        for (int type :
                new int[] {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY}) {
            BufferedImage image = new BufferedImage(3, 2, type);
            int bands = image.getRaster().getNumBands();
            // 128 of 255; in 16 bits every byte twice.
            int half = type == BufferedImage.TYPE_USHORT_GRAY ? 0x8080 : 0x80;
            for (int band = 0; band < bands; band++) {
                image.getRaster().setSample(2, 1, band, half);
            }
            Path file = folder.resolve(type + ".png");
            ImageIO.write(image, "png", file.toFile());

            BodyTexture texture = BodyTextures.load(file.toString(), BlobCache.NONE);

            for (int c = 0; c < 3; c++) {
                assertThat(channel(texture, 2, 1, c)).as("type %d", type).isEqualTo(0x80);
                assertThat(channel(texture, 0, 0, c)).as("type %d", type).isZero();
            }
            assertThat(channel(texture, 2, 1, 3)).isEqualTo(255);
        }
    }

    @Test
    void invalidPicturesAreRefusedInOneLine() throws IOException {
        Path text = Files.writeString(folder.resolve("x.png"), "no picture");
        assertThatThrownBy(() -> BodyTextures.load(text.toString(), BlobCache.NONE))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("x.png");
        assertThatThrownBy(() -> BodyTextures.load("elafe", BlobCache.NONE))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("elaphe, xenopeltis, dark, none");
    }
}
