package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.setting.SettingException;

class HeightImageReaderTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff", "bmp"})
    void readsAll256GreysAsStored(String format) throws IOException {
        HeightImage image = read(TestImages.grey8(16, 16, (c, r, b) -> r * 16 + c), "grey." + format);

        assertThat(image.format()).isEqualTo(SampleFormat.UNSIGNED_8);
        for (int i = 0; i < 256; i++) {
            assertThat(image.samples()[i]).isEqualTo(i);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff"})
    void readsAll65536GreysAsStored(String format) throws IOException {
        HeightImage image = read(TestImages.grey16(256, 256, (c, r, b) -> r * 256 + c), "grey." + format);

        assertThat(image.format()).isEqualTo(SampleFormat.UNSIGNED_16);
        for (int i = 0; i < 65536; i++) {
            assertThat(image.samples()[i]).isEqualTo(i);
        }
    }

    @Test
    void readsFloatTiffBitByBit() throws IOException {
        TestImages.Samples samples = (c, r, b) -> (float) ((c - 3) * 1e-9 + r * 1e-3);
        HeightImage image = read(TestImages.grey32f(7, 5, samples), "heights.tiff");

        assertThat(image.format()).isEqualTo(SampleFormat.FLOAT);
        for (int i = 0; i < 35; i++) {
            assertThat(image.samples()[i]).isEqualTo(samples.at(i % 7, i / 7, 0));
        }
    }

    @Test
    void keepsNanAndInfinityOfAFloatTiffAsMissingSamples() throws IOException {
        HeightImage image = read(
                TestImages.grey32f(3, 1, (c, r, b) -> new double[] {1, Double.NaN, Double.NEGATIVE_INFINITY}[c]),
                "holes.tiff");

        assertThat(image.samples()).containsExactly(1, Double.NaN, Double.NEGATIVE_INFINITY);
    }

    @Test
    void readsSigned16BitTiffWithItsSign() throws IOException {
        byte[] data = ByteBuffer.allocate(6)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putShort((short) -32768)
                .putShort((short) -1)
                .putShort((short) 32767)
                .array();
        Path file = new TinyTiff(3, 1, 16, data).with(TinyTiff.SAMPLE_FORMAT, 2).write(folder.resolve("signed.tif"));

        HeightImage image = HeightImageReader.read(file, Optional.empty());

        assertThat(image.format()).isEqualTo(SampleFormat.SIGNED_16);
        assertThat(image.samples()).containsExactly(-32768, -1, 32767);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff", "bmp"})
    void putsRow0OnTopAndColumn0Left(String format) throws IOException {
        HeightImage image = read(TestImages.grey8(3, 2, (c, r, b) -> 10 * r + c), "corner." + format);

        assertThat(image.columns()).isEqualTo(3);
        assertThat(image.rows()).isEqualTo(2);
        assertThat(image.samples()).containsExactly(0, 1, 2, 10, 11, 12);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff", "bmp"})
    void takesRedWhenRedGreenAndBlueAreEqual(String format) throws IOException {
        HeightImage image = read(TestImages.rgb(4, 3, (c, r, b) -> 20 * r + c), "equal." + format);

        assertThat(image.samples()).startsWith(0, 1, 2, 3, 20);
        assertThat(image.description()).contains("8-bit RGB", "red channel");
    }

    @ParameterizedTest
    @CsvSource({"RED, 50", "GREEN, 100", "BLUE, 150", "ALPHA, 200"})
    void readsTheChosenChannelOfRgba(Channel channel, double base) throws IOException {
        for (String format : new String[] {"png", "tiff"}) {
            Path file = TestImages.write(
                    TestImages.rgba(2, 2, (c, r, b) -> 50 * (b + 1) + 2 * r + c), folder.resolve("rgba." + format));

            double[] samples =
                    HeightImageReader.read(file, Optional.of(channel)).samples();

            assertThat(samples).as(format).containsExactly(base, base + 1, base + 2, base + 3);
        }
    }

    @Test
    void readsTheChosenChannelOf16BitRgb() throws IOException {
        Path file = TestImages.write(
                TestImages.wide16(2, 1, 3, (c, r, b) -> 10_000 * (b + 1) + c), folder.resolve("wide.png"));

        assertThat(HeightImageReader.read(file, Optional.of(Channel.GREEN)).samples())
                .containsExactly(20_000, 20_001);
    }

    @Test
    void asksForTheChannelWhenColoursDiffer() throws IOException {
        assertThatThrownBy(() -> read(TestImages.rgb(2, 2, (c, r, b) -> c == 1 && r == 1 ? b : 7), "colours.png"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("colours.png")
                .hasMessageStartingWith("channel is missing");
    }

    @ParameterizedTest
    @EnumSource(names = {"RED", "GREEN", "BLUE", "ALPHA"})
    void refusesAChannelThatAGreyImageLacks(Channel channel) throws IOException {
        Path file = TestImages.write(TestImages.grey8(2, 2, (c, r, b) -> c), folder.resolve("grey.png"));

        assertThatThrownBy(() -> HeightImageReader.read(file, Optional.of(channel)))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("grey.png")
                .hasMessageContaining("no channel " + channel.label());
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "tiff"})
    void readsTheColoursOfAPaletteAndNotItsIndices(String format) throws IOException {
        byte[] greys = new byte[256];
        for (int i = 0; i < 256; i++) {
            greys[i] = (byte) (255 - i);
        }
        HeightImage image = read(TestImages.palette(16, 16, greys, (c, r, b) -> r * 16 + c), "palette." + format);

        for (int i = 0; i < 256; i++) {
            assertThat(image.samples()[i]).isEqualTo(255 - i);
        }
    }

    @Test
    void takesTransparentPixelsAsMissing() throws IOException {
        HeightImage image =
                read(TestImages.rgba(3, 1, (c, r, b) -> b < 3 ? 90 + c : new int[] {255, 0, 1}[c]), "holes.png");

        assertThat(image.samples()).containsExactly(90, Double.NaN, 92);
    }

    private HeightImage read(BufferedImage image, String name) throws IOException {
        return HeightImageReader.read(TestImages.write(image, folder.resolve(name)), Optional.empty());
    }
}
