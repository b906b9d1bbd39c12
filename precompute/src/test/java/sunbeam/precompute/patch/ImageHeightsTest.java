package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT_UNIT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.awt.Transparency;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanFormat;
import sunbeam.precompute.setting.SettingException;

/** Images as files of heights: which samples are read, which mark a missing one, which channel they come from, and what is refused. */
class ImageHeightsTest {
    // Rounding of a sample of 65535 through meters and back.
    private static final double ROUNDING = 1e-10;

    @TempDir
    Path folder;

    private double[] read(BufferedImage image, String name, double fullScale) throws IOException {
        return TestImages.samples(TestImages.write(image, folder.resolve(name)), fullScale);
    }

    private static void assertSamples(double[] samples, double... expected) {
        assertThat(samples).containsExactly(expected, within(ROUNDING));
    }

    @ParameterizedTest
    @CsvSource({"png, 8", "tiff, 8", "bmp, 8", "png, 16", "tiff, 16"})
    void readsAllGraysAsStored(String format, int bits) throws IOException {
        int side = 1 << (bits / 2);
        TestImages.Samples grays = (c, r, b) -> r * side + c;
        BufferedImage image = bits == 8 ? TestImages.gray8(side, side, grays) : TestImages.gray16(side, side, grays);
        double[] samples = read(image, "grey." + format, (1 << bits) - 1);
        assertSamples(samples, IntStream.range(0, 1 << bits).asDoubleStream().toArray());
    }

    /** Twice as many samples per length along x, without a unit in PNG, which are pixels twice as tall as wide. */
    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp"})
    void pixelsThatAreNotSquareKeepTheirRatio(String format) throws IOException {
        Path file = TestImages.write(TestImages.gray8(4, 2, (c, r, b) -> c), folder.resolve("tall." + format));
        byte[] image = Files.readAllBytes(file);
        ByteBuffer stated = ByteBuffer.allocate(image.length + 21);
        if (format.equals("png")) {
            // Signature and the chunk IHDR take 33 bytes.
            stated.put(image, 0, 33).putInt(9).put("pHYs".getBytes(StandardCharsets.US_ASCII));
            stated.putInt(200).putInt(100).put((byte) 0);
            CRC32 sum = new CRC32();
            sum.update(stated.array(), 37, 13);
            stated.putInt((int) sum.getValue()).put(image, 33, image.length - 33);
        } else {
            stated.order(ByteOrder.LITTLE_ENDIAN).put(image).putInt(38, 200).putInt(42, 100);
        }
        try (ScanBytes bytes = ScanBytes.open(Files.write(file, stated.array()))) {
            ChannelList channels =
                    ScanFormat.find(bytes, Optional.empty()).orElseThrow().open(bytes);
            assertThat(channels.channels().get(0).extent())
                    .isEqualTo(new Extent(Optional.empty(), Optional.empty(), 2));
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
                .hasMessageContainingAll(
                        "colors.png is known to hold heights; choose one of red, green, blue", "false colors");
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "tiff"})
    void readsTheColorsOfAPaletteAndNotItsIndices(String format) throws IOException {
        byte[] grays = new byte[256];
        for (int i = 0; i < 256; i++) {
            grays[i] = (byte) (255 - i);
        }
        double[] samples = read(TestImages.palette(16, 16, grays, (c, r, b) -> r * 16 + c), "palette." + format, 255);
        assertSamples(samples, IntStream.range(0, 256).mapToDouble(i -> 255 - i).toArray());
    }

    @ParameterizedTest
    @ValueSource(ints = {Transparency.OPAQUE, Transparency.BITMASK, Transparency.TRANSLUCENT})
    void transparentColorsOfAPaletteAreMissing(int transparency) throws IOException {
        byte[] grays = {10, 20, 30};
        byte[] alpha = {(byte) 255, (byte) (transparency == Transparency.TRANSLUCENT ? 100 : 255), 0};
        IndexColorModel colors = transparency == Transparency.OPAQUE
                ? new IndexColorModel(8, 3, grays, grays, grays)
                : new IndexColorModel(8, 3, grays, grays, grays, alpha);
        assertThat(colors.getTransparency()).isEqualTo(transparency);
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_BYTE_INDEXED, colors);
        image.getRaster().setSamples(0, 0, 3, 1, 0, new int[] {0, 1, 2});

        assertSamples(read(image, "palette.png", 255), 10, 20, transparency == Transparency.OPAQUE ? 30 : Double.NaN);
    }

    @Test
    void takesTransparentPixelsAsMissing() throws IOException {
        BufferedImage image = TestImages.rgba(3, 1, (c, r, b) -> b < 3 ? 90 + c : new int[] {255, 0, 1}[c]);

        assertSamples(read(image, "holes.png", 255), 90, Double.NaN, 92);
    }

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
    void refusesMisleadingAndHugeFiles() throws IOException {
        Path bmp = TestImages.write(TestImages.gray8(2, 2, (c, r, b) -> c), folder.resolve("jpeg.bmp"));
        byte[] content = Files.readAllBytes(bmp);
        content[30] = 4;
        assertRefused(Files.write(bmp, content), "around another image");
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_4BYTE_ABGR_PRE);
        image.getRaster().setPixels(0, 0, 2, 1, new int[] {9, 9, 9, 255, 9, 9, 9, 128});
        assertRefused(TestImages.write(image, folder.resolve("veiled.tiff")), "multiplied by alpha");
        Path huge = new TinyTiff(40_000, 40_000, 8, new byte[4]).write(folder.resolve("huge.tif"));
        assertRefused(huge, "40000 x 40000", "16384");
        TinyTiff tiles = new TinyTiff(4, 4, 8, new byte[16])
                .with(TIFF.TAG_TILE_WIDTH, 60_000)
                .with(TIFF.TAG_TILE_HEIGTH, 60_000);
        assertRefused(tiles.write(folder.resolve("tiles.tif")), "tiles of 3600000000 samples");
    }

    @Test
    void refusesAnImageThatTheHeapCannotHold() {
        assertThatThrownBy(() -> Samples.requireMemory(1L << 26, 1L << 40))
                .isInstanceOf(ScanException.class)
                .hasMessageContainingAll("needs 1101.1 GB", "-Xmx");
    }

    @ParameterizedTest
    @CsvSource({
        TIFF.TAG_ORIENTATION + ", 3, orientation tag 3",
        TIFF.TAG_PHOTOMETRIC_INTERPRETATION + ", 5, photometric interpretation 5",
        TIFF.TAG_COMPRESSION + ", 7, JPEG compression",
        TIFF.TAG_COMPRESSION + ", 50000, compression 50000",
        TIFF.TAG_BITS_PER_SAMPLE + ", 12, 12-bit samples of format 1",
        TIFF.TAG_STRIP_BYTE_COUNTS + ", 15, has 15 of 16 bytes of samples",
        TIFF.TAG_STRIP_OFFSETS + ", 1000, damaged",
        TIFF.TAG_STRIP_BYTE_COUNTS + ", 2000000000, announces 2000000000 bytes of samples but ends after",
        TIFF.TAG_SAMPLES_PER_PIXEL + ", 60000, 60000 channels",
        TIFF.TAG_SAMPLES_PER_PIXEL + ", 5, 5 channels",
        TIFF.TAG_SAMPLE_FORMAT + ", 4, 8-bit samples of format 4",
        TIFF.TAG_SAMPLE_FORMAT + ", 3, 8-bit samples of format 3"
    })
    void refusesATiffWithMisleadingTags(int tag, int value, String complaint) throws IOException {
        Path file = new TinyTiff(4, 4, 8, new byte[16]).with(tag, value).write(folder.resolve("odd.tif"));

        assertRefused(file, complaint);
    }

    /** Bytes 0 to 15, of which byte i is a height of i / 10 + 5 um. */
    @Test
    void gdalsScaleOffsetAndUnitAreUsedWithANote() throws IOException {
        byte[] bytes = new byte[16];
        IntStream.range(0, 16).forEach(i -> bytes[i] = (byte) i);
        String item = "<Item name=\"S\" sample=\"%d\" role=\"%s\">%s</Item>";
        String scaled = item.formatted(0, "scale", "0.1")
                + item.formatted(1, "scale", "7")
                + item.formatted(0, "offset", "5")
                + item.formatted(0, "unittype", "um");
        Path file = new TinyTiff(4, 4, 8, bytes).metadata(scaled).write(folder.resolve("scaled.tif"));

        MeasuredHeights used = MeasuredHeights.read(
                file, PatchRequests.of(file, WIDTH, "100um").choices());
        assertThat(used.map().heights()[3]).isCloseTo(5.3e-6, within(1e-18));
        assertThat(used.notes())
                .containsExactly("heights are 0.1 times the stored samples plus 5, as GDAL's metadata declares");
        MeasuredHeights overruled = MeasuredHeights.read(
                file, PatchRequests.of(file, WIDTH, "100um", HEIGHT_UNIT, "nm").choices());
        assertThat(overruled.map().heights()[3]).isCloseTo(5.3e-9, within(1e-21));
        assertThat(overruled.notes()).anyMatch(note -> note.contains("though the file says that they are in um"));

        new TinyTiff(4, 4, 8, bytes)
                .metadata(item.formatted(0, "scale", "a tenth"))
                .write(file);
        assertRefused(file, "has \"a tenth\" for \"scale\"");
    }

    private static void assertRefused(Path file, String... complaints) {
        assertThatThrownBy(() -> TestImages.samples(file, 255))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(file.toString())
                .satisfies(e -> assertThat(e.getMessage()).contains(complaints).doesNotContain("\n"));
    }

    /** A TIFF composed of tags: unusual, damaged and hostile files that the JDK does not write. */
    private static final class TinyTiff {
        private static final int TYPE_SHORT = 3;
        private static final int TYPE_LONG = 4;
        private static final int HEADER_BYTES = 8;

        private final Map<Integer, Integer> tags = new TreeMap<>();
        private final byte[] data;
        private byte[] metadata = new byte[0];

        /** A gray, uncompressed image in one strip, little-endian. */
        TinyTiff(int columns, int rows, int bits, byte[] data) {
            this.data = data;
            with(TIFF.TAG_IMAGE_WIDTH, columns)
                    .with(TIFF.TAG_IMAGE_HEIGHT, rows)
                    .with(TIFF.TAG_BITS_PER_SAMPLE, bits);
            with(TIFF.TAG_COMPRESSION, 1)
                    .with(TIFF.TAG_PHOTOMETRIC_INTERPRETATION, 1)
                    .with(TIFF.TAG_SAMPLES_PER_PIXEL, 1);
            with(TIFF.TAG_STRIP_OFFSETS, HEADER_BYTES).with(TIFF.TAG_STRIP_BYTE_COUNTS, data.length);
            with(TIFF.TAG_ROWS_PER_STRIP, rows);
        }

        TinyTiff with(int tag, int value) {
            tags.put(tag, value);
            return this;
        }

        /** Adds the tag GDAL_METADATA, which the others precede. */
        TinyTiff metadata(String items) {
            metadata = ("<GDALMetadata>" + items + "</GDALMetadata>\0").getBytes(StandardCharsets.US_ASCII);
            return this;
        }

        Path write(Path file) throws IOException {
            int before = HEADER_BYTES + data.length;
            int count = tags.size() + (metadata.length > 0 ? 1 : 0);
            ByteBuffer out = ByteBuffer.allocate(before + metadata.length + 2 + 12 * count + 4)
                    .order(ByteOrder.LITTLE_ENDIAN);
            out.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(before + metadata.length);
            out.put(data).put(metadata).putShort((short) count);
            tags.forEach((tag, value) -> out.putShort(tag.shortValue())
                    // Most tags must be short; sizes and offsets may be long.
                    .putShort((short) (value < 1 << 16 ? TYPE_SHORT : TYPE_LONG))
                    .putInt(1)
                    .putInt(value));
            if (metadata.length > 0) {
                out.putShort((short) 42_112).putShort((short) 2).putInt(metadata.length);
                out.putInt(before);
            }
            out.putInt(0);
            return Files.write(file, out.array());
        }
    }
}
