package sunbeam.app.scene.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.precompute.files.InputException;

/** Textures of bodies, from files and of scales. */
class BodyTexturesTest {
    @TempDir
    private Path folder;

    private Path file() {
        return folder.resolve("texture");
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
            ImageIO.write(image, "png", file().toFile());

            BodyTexture texture = BodyTexture.load(file().toString(), BlobCache.NONE);

            assertThat(texture.color(5)).as("type %d", type).isEqualTo(0x808080);
            assertThat(texture.color(0)).as("type %d", type).isZero();
            assertThat(texture.rgba()[4 * 5 + 3]).as("opaque").isEqualTo((byte) 255);
        }
    }

    @Test
    void invalidPicturesAreRefusedInOneLine() throws IOException {
        Path text = Files.writeString(folder.resolve("x.png"), "no picture");
        assertThatThrownBy(() -> BodyTexture.load(text.toString(), BlobCache.NONE))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("x.png");
        assertThatThrownBy(() -> BodyTexture.load("elafe", BlobCache.NONE))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("elaphe, xenopeltis, dark, none");
    }

    @Test
    void aPictureThatDoesNotFitTheHeapIsRefusedBeforeItIsDecoded() throws IOException {
        ImageIO.write(new BufferedImage(24, 17, BufferedImage.TYPE_INT_RGB), "png", file().toFile());
        byte[] png = Files.readAllBytes(file());
        // Width and height in the header; readers check its checksum after the size.
        ByteBuffer.wrap(png).putInt(16, 8000).putInt(20, 8000);
        Files.write(file(), png);
        assertThatThrownBy(() -> BodyTexture.read("texture", file(), "", 512L << 20))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("8000 x 8000", "too many for Java's memory", "SUNBEAM_JAVA_OPTIONS=-Xmx1024m");
    }
}
