package sunbeam.app.scene.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BandedSampleModel;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferFloat;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.InputException;

class BodyTexturesTest {
    @TempDir
    private Path folder;

    private static int channel(BodyTexture texture, int x, int y, int c) {
        return texture.rgba()[4 * (y * texture.width() + x) + c] & 0xff;
    }

    @Test
    void greyPicturesAreAsBrightAsColoredOnesOfTheSameNumbers() throws IOException {
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

            BodyTexture texture = BodyTextures.load(file.toString());

            for (int c = 0; c < 3; c++) {
                assertThat(channel(texture, 2, 1, c)).as("type %d", type).isEqualTo(0x80);
                assertThat(channel(texture, 0, 0, c)).as("type %d", type).isZero();
            }
            assertThat(channel(texture, 2, 1, 3)).isEqualTo(255);
        }
    }

    @Test
    void greyPicturesOfFloatsAreLinear() throws IOException {
        float[] values = {0, 0.25f, 0.5f, 1};
        WritableRaster raster = Raster.createWritableRaster(
                new BandedSampleModel(DataBuffer.TYPE_FLOAT, 4, 1, 1), new DataBufferFloat(values, 4), null);
        ColorModel model = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_GRAY), false, false, Transparency.OPAQUE, DataBuffer.TYPE_FLOAT);
        Path file = folder.resolve("floats.tif");
        assertThat(ImageIO.write(new BufferedImage(model, raster, false, null), "tiff", file.toFile()))
                .isTrue();
        BodyTexture texture = BodyTextures.load(file.toString());
        // 255 times the sRGB curve of 0.25 and 0.5 (IEC 61966-2-1); Java rounds by its own tables.
        int[] expected = {0, 137, 188, 255};
        for (int x = 0; x < 4; x++) {
            assertThat(channel(texture, x, 0, 0)).isCloseTo(expected[x], within(1));
        }
    }

    @Test
    void whatIsNoPictureIsRefusedInOneLine() throws IOException {
        Path text = Files.writeString(folder.resolve("x.png"), "no picture");
        assertThatThrownBy(() -> BodyTextures.load(text.toString()))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("x.png");
        assertThatThrownBy(() -> BodyTextures.load("elafe"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("elaphe, xenopeltis, none");
    }
}
