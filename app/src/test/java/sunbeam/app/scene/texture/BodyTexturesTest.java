package sunbeam.app.scene.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BandedSampleModel;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.FileImageOutputStream;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.scene.texture.BodyColors.SnakeHead;
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

    /** Linear light of 32 bits: the sRGB curve makes 0.5 to 188 of 255. */
    @Test
    void graysOutsideOfTheirRangeAreClipped() throws IOException {
        float[] grays = {-0.01f, 0.5f, 1.5f, Float.NaN, Float.POSITIVE_INFINITY, -1e30f};
        BandedSampleModel floats = new BandedSampleModel(DataBuffer.TYPE_FLOAT, grays.length, 1, 1);
        ComponentColorModel model = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_GRAY), false, false, Transparency.OPAQUE, DataBuffer.TYPE_FLOAT);
        WritableRaster raster = Raster.createWritableRaster(floats, null);
        raster.setSamples(0, 0, grays.length, 1, 0, grays);
        // The JDK's writer; others know no floats.
        ImageWriter writer = ImageIO.getImageWritersByMIMEType("image/tiff").next();
        for (var writers = ImageIO.getImageWritersByMIMEType("image/tiff"); writers.hasNext(); ) {
            ImageWriter next = writers.next();
            writer = next.getClass().getName().startsWith("com.sun.") ? next : writer;
        }
        try (FileImageOutputStream out = new FileImageOutputStream(file().toFile())) {
            writer.setOutput(out);
            writer.write(new BufferedImage(model, raster, false, null));
        }

        BodyTexture texture = BodyTexture.load(file().toString(), BlobCache.NONE);

        assertThat(IntStream.range(0, grays.length).map(texture::color))
                .containsExactly(0, 0xbcbcbc, 0xffffff, 0, 0xffffff, 0);
    }

    /** Noise varies a color by a quarter; the three colors of the corn snake's back differ by more in some channel. */
    @Test
    void aScaleOfTheCornSnakeHasOneColor() {
        BodyColors.Elaphe snake = new BodyColors.Elaphe();
        Random random = new Random(5);
        for (int i = 0; i < 2000; i++) {
            double along = 0.1 + 0.8 * random.nextDouble();
            double around = 0.6 * (2 * random.nextDouble() - 1);
            double[] middle = ScaleRelief.middleOfScale(Scales.KEELED, along, around);
            // A scale is seen in its own middle.
            assertThat(ScaleRelief.middleOfScale(Scales.KEELED, middle[0], middle[1]))
                    .containsExactly(middle, within(1e-9));
            Vector3dc here = snake.at(along, around);
            Vector3dc there = snake.at(middle[0], middle[1]);
            for (int c = 0; c < 3; c++) {
                assertThat(here.get(c) / there.get(c))
                        .as("at %s, %s", along, around)
                        .isBetween(1 / 1.8, 1.8);
            }
        }
    }

    @Test
    void onlyEyesHaveNoNanostructure() {
        BodyTexture snake = BodyTexture.load("xenopeltis", BlobCache.NONE);
        int row = (int) (snake.height() * 0.5 * (1 - SnakeHead.EYE_AROUND));
        int column = (int) (snake.width() * ScaleRelief.BEGIN * SnakeHead.EYE_ALONG);
        int bare = 0;
        for (int texel = 0; texel < snake.width() * snake.height(); texel++) {
            bare += snake.rgba()[4 * texel + 3] == 0 ? 1 : 0;
        }
        for (int eye : new int[] {row, snake.height() - 1 - row}) {
            assertThat(snake.rgba()[4 * (eye * snake.width() + column) + 3]).isZero();
        }
        // Two ellipses on the head.
        assertThat(bare / (double) (snake.width() * snake.height())).isBetween(1e-4, 3e-3);
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
