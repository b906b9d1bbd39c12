package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

class BadImageTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({
        "'', is empty",
        "'heights,1,2,3', is neither an image nor",
        "GIF89a, is a GIF",
        "'II+\0', is a damaged TIFF"
    })
    void refusesOtherFilesThanImages(String content, String complaint) throws IOException {
        assertRefused(Files.writeString(folder.resolve("scan.png"), content), complaint);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "tiff"})
    void refusesATruncatedFile(String format) throws IOException {
        Path file = TestImages.write(TestImages.gray8(40, 40, (c, r, b) -> c * r), folder.resolve("cut." + format));
        byte[] content = Files.readAllBytes(file);
        for (int tenths = 1; tenths < 10; tenths++) {
            Files.write(file, Arrays.copyOf(content, content.length * tenths / 10));
            assertThatThrownBy(() -> TestImages.samples(file, 255))
                    .as(tenths + " tenths")
                    .isInstanceOf(InputException.class)
                    .hasMessageContaining("cut." + format);
        }
    }

    @Test
    void refusesABmpAroundAnotherImage() throws IOException {
        Path file = TestImages.write(TestImages.gray8(2, 2, (c, r, b) -> c), folder.resolve("jpeg.bmp"));
        byte[] content = Files.readAllBytes(file);
        content[30] = 4;
        Files.write(file, content);

        assertRefused(file, "around another image");
    }

    @Test
    void refusesHeightsMultipliedByAlpha() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_4BYTE_ABGR_PRE);
        image.getRaster().setPixels(0, 0, 2, 1, new int[] {9, 9, 9, 255, 9, 9, 9, 128});
        Path file = TestImages.write(image, folder.resolve("veiled.tiff"));

        assertRefused(file, "multiplied by alpha");
    }

    @Test
    void refusesAHugeTiffByItsTags() throws IOException {
        assertRefused(
                new TinyTiff(40_000, 40_000, 8, new byte[4]).write(folder.resolve("huge.tif")),
                "40000 x 40000",
                "16384");
    }

    @Test
    void refusesAnImageThatTheHeapCannotHold() {
        assertThatThrownBy(() -> ScanLimits.requireMemory(1L << 26, 1L << 40))
                .isInstanceOf(ScanException.class)
                .hasMessageContaining("needs 1101.1 GB")
                .hasMessageContaining("-Xmx");
    }

    @ParameterizedTest
    @CsvSource({
        TinyTiff.ORIENTATION + ", 3, orientation tag 3",
        TinyTiff.PHOTOMETRIC + ", 5, photometric interpretation 5",
        TinyTiff.COMPRESSION + ", 7, JPEG compression",
        TinyTiff.COMPRESSION + ", 50000, compression 50000",
        TinyTiff.BITS + ", 12, 12-bit samples of format 1",
        TinyTiff.STRIP_BYTES + ", 15, has 15 of 16 bytes of samples",
        TinyTiff.STRIP_OFFSETS + ", 1000, damaged",
        TinyTiff.STRIP_BYTES + ", 2000000000, announces 2000000000 bytes of samples but ends after",
        TinyTiff.CHANNELS + ", 60000, 60000 channels",
        TinyTiff.CHANNELS + ", 5, 5 channels",
        TinyTiff.SAMPLE_FORMAT + ", 4, 8-bit samples of format 4",
        TinyTiff.SAMPLE_FORMAT + ", 3, 8-bit samples of format 3"
    })
    void refusesATiffWithMisleadingTags(int tag, int value, String complaint) throws IOException {
        Path file = new TinyTiff(4, 4, 8, new byte[16]).with(tag, value).write(folder.resolve("odd.tif"));

        assertRefused(file, complaint);
    }

    @Test
    void refusesATiffWithHugeTiles() throws IOException {
        Path file = new TinyTiff(4, 4, 8, new byte[16])
                .with(TinyTiff.TILE_WIDTH, 60_000)
                .with(TinyTiff.TILE_LENGTH, 60_000)
                .write(folder.resolve("tiles.tif"));

        assertRefused(file, "tiles of 3600000000 samples");
    }

    private static void assertRefused(Path file, String... complaints) {
        assertThatThrownBy(() -> TestImages.samples(file, 255))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(file.toString())
                .satisfies(e -> assertThat(e.getMessage()).contains(complaints).doesNotContain("\n"));
    }
}
