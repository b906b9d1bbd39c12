package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.setting.SettingException;

/** Images as files of heights: which samples are read, which mark a missing one, and which channel they come from. */
class ImageHeightsTest {
    // Rounding of a sample of 65535 through meters and back.
    private static final double ROUNDING = 1e-10;

    @TempDir
    Path folder;

    private double[] read(BufferedImage image, String name, double fullScale) throws IOException {
        return TestImages.samples(TestImages.write(image, folder.resolve(name)), fullScale);
    }

    private static void assertSamples(double[] samples, double... expected) {
        assertThat(samples).hasSameSizeAs(expected);
        for (int i = 0; i < samples.length; i++) {
            if (Double.isFinite(expected[i])) {
                assertThat(samples[i]).as("sample %d", i).isCloseTo(expected[i], within(ROUNDING));
            } else {
                assertThat(Double.isFinite(samples[i])).as("sample %d", i).isFalse();
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"png, 8", "tiff, 8", "bmp, 8", "png, 16", "tiff, 16"})
    void readsAllGraysAsStored(String format, int bits) throws IOException {
        int side = 1 << (bits / 2);
        TestImages.Samples grays = (c, r, b) -> r * side + c;
        BufferedImage image = bits == 8 ? TestImages.gray8(side, side, grays) : TestImages.gray16(side, side, grays);
        double[] samples = read(image, "grey." + format, (1 << bits) - 1);

        for (int i = 0; i < side * side; i++) {
            assertThat(samples[i]).isCloseTo(i, within(ROUNDING));
        }
    }

    @Test
    void floatsMayBeMissing() throws IOException {
        double[] stored = {1, Double.NaN, Double.NEGATIVE_INFINITY};

        assertSamples(read(TestImages.gray32f(3, 1, (c, r, b) -> stored[c]), "holes.tiff", 1), stored);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff", "bmp"})
    void equalColorsAreAGray(String format) throws IOException {
        assertSamples(read(TestImages.rgb(3, 2, (c, r, b) -> 20 * r + c), "equal." + format, 255), 0, 1, 2, 20, 21, 22);
    }

    @ParameterizedTest
    @CsvSource({"red, 50", "GREEN, 100", "blue, 150", "alpha, 200"})
    void readsTheChosenChannelOfRgba(String channel, double base) throws IOException {
        for (String format : new String[] {"png", "tiff"}) {
            Path file = TestImages.write(
                    TestImages.rgba(2, 2, (c, r, b) -> 50 * (b + 1) + 2 * r + c), folder.resolve("rgba." + format));

            assertSamples(TestImages.samples(file, channel, 255), base, base + 1, base + 2, base + 3);
        }
    }

    @Test
    void asksForTheChannelWhenColorsDiffer() throws IOException {
        assertThatThrownBy(() -> read(TestImages.rgb(2, 2, (c, r, b) -> c == 1 && r == 1 ? b : 7), "colors.png", 255))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("colors.png is known to hold heights; choose one of red, green, blue")
                .hasMessageContaining("false colors");
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "tiff"})
    void readsTheColorsOfAPaletteAndNotItsIndices(String format) throws IOException {
        byte[] grays = new byte[256];
        for (int i = 0; i < 256; i++) {
            grays[i] = (byte) (255 - i);
        }
        double[] samples = read(TestImages.palette(16, 16, grays, (c, r, b) -> r * 16 + c), "palette." + format, 255);

        for (int i = 0; i < 256; i++) {
            assertThat(samples[i]).isCloseTo(255 - i, within(ROUNDING));
        }
    }

    @Test
    void takesTransparentPixelsAsMissing() throws IOException {
        BufferedImage image = TestImages.rgba(3, 1, (c, r, b) -> b < 3 ? 90 + c : new int[] {255, 0, 1}[c]);

        assertSamples(read(image, "holes.png", 255), 90, Double.NaN, 92);
    }
}
