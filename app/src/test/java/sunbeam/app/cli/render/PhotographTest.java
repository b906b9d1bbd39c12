package sunbeam.app.cli.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import java.util.zip.DeflaterInputStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.files.InputException;

class PhotographTest {
    private static final int GRAY = 1;
    private static final int RGB = 3;
    private static final int RGBA = 4;
    // Samples have 16 bits.
    private static final Offset<Float> EXACT = within(1e-5f);

    private Path file;

    @BeforeEach
    void name(@TempDir Path folder) {
        file = folder.resolve("photo");
    }

    private static byte[] chunk(String type, byte[] data) {
        ByteBuffer chunk = ByteBuffer.allocate(12 + data.length).putInt(data.length);
        chunk.put(type.getBytes(StandardCharsets.ISO_8859_1)).put(data);
        CRC32 checksum = new CRC32();
        checksum.update(chunk.array(), 4, 4 + data.length);
        return chunk.putInt((int) checksum.getValue()).array();
    }

    /** Writes a PNG of 16 bits with an additional chunk, and returns its bytes. */
    private byte[] png(int columns, int channels, byte[] chunk, int... samples) throws IOException {
        ImageTypeSpecifier type = ImageTypeSpecifier.createInterleaved(
                ColorSpace.getInstance(channels == GRAY ? ColorSpace.CS_GRAY : ColorSpace.CS_sRGB),
                IntStream.range(0, channels).toArray(),
                DataBuffer.TYPE_USHORT,
                channels == RGBA,
                false);
        BufferedImage image = type.createBufferedImage(columns, samples.length / channels / columns);
        image.getRaster().setPixels(0, 0, columns, image.getHeight(), samples);
        // Signature and IHDR have 33 bytes.
        return write(inserted(written(image, "png"), 33, chunk));
    }

    private byte[] write(byte[] bytes) throws IOException {
        Files.write(file, bytes);
        return bytes;
    }

    private static byte[] written(BufferedImage image, String format) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, format, bytes);
        return bytes.toByteArray();
    }

    private static byte[] inserted(byte[] bytes, int at, byte[] more) {
        return ByteBuffer.allocate(bytes.length + more.length)
                .put(bytes, 0, at)
                .put(more)
                .put(bytes, at, bytes.length - at)
                .array();
    }

    private Photograph.Linear whole() {
        Photograph photo = Photograph.read(file);
        return photo.reduced(photo.width(), photo.height());
    }

    private static float luminance(Photograph.Linear photo, int pixel) {
        return photo.picture().rgba()[4 * pixel + 1];
    }

    private static byte[] exif(int orientation) {
        return ByteBuffer.allocate(26)
                .put("MM\0*".getBytes(StandardCharsets.ISO_8859_1))
                .putInt(8)
                .putShort((short) 1)
                .put(new byte[] {1, 0x12, 0, 3, 0, 0, 0, 1})
                .putShort((short) orientation)
                .array();
    }

    private static byte[] profile(int space) throws IOException {
        return profile(ICC_Profile.getInstance(space).getData());
    }

    private static byte[] profile(byte[] data) throws IOException {
        byte[] deflated = new DeflaterInputStream(new ByteArrayInputStream(data)).readAllBytes();
        return chunk("iCCP", inserted(new byte[] {'p', 0, 0}, 3, deflated));
    }

    /** The corners in which the file's first row begins and ends, as Exif 2.32 describes each value. */
    @ParameterizedTest
    @CsvSource({
        "1, top left, top right", "2, top right, top left", "3, bottom right, bottom left",
        "4, bottom left, bottom right", "5, top left, bottom left", "6, top right, bottom right",
        "7, bottom right, top right", "8, bottom left, top left", "0, top left, top right"
    })
    void isUprightWhateverItsOrientation(int orientation, String begin, String end) throws IOException {
        // The first of two rows of three begins with white and ends with half of its light.
        int half = 48_194;
        png(3, GRAY, chunk("eXIf", exif(orientation)), 65_535, 0, half, 0, 0, 0);
        Photograph photo = Photograph.read(file);
        boolean upright = orientation < 5;
        assertThat(photo.width()).isEqualTo(upright ? 3 : 2);
        assertThat(photo.height()).isEqualTo(upright ? 2 : 3);
        Photograph.Linear linear = whole();
        assertThat(luminance(linear, corner(photo, begin))).isEqualTo(1, EXACT);
        assertThat(luminance(linear, corner(photo, end))).isEqualTo(0.5f, within(1e-4f));
        assertThat(linear.clipped()[corner(photo, begin)]).isTrue();
        assertThat(linear.clipped()[corner(photo, end)]).isFalse();
    }

    private static int corner(Photograph photo, String name) {
        return (name.startsWith("top") ? 0 : photo.width() * (photo.height() - 1))
                + (name.endsWith("left") ? 0 : photo.width() - 1);
    }

    @Test
    void aJpegsExifDataAreFound() throws IOException {
        byte[] exif = exif(6);
        byte[] segment = ByteBuffer.allocate(10 + exif.length)
                .putShort((short) 0xffe1)
                .putShort((short) (8 + exif.length))
                .put("Exif\0\0".getBytes(StandardCharsets.ISO_8859_1))
                .put(exif)
                .array();
        write(inserted(written(new BufferedImage(32, 16, BufferedImage.TYPE_INT_RGB), "jpeg"), 2, segment));
        assertThat(Photograph.read(file).height()).isEqualTo(32);
    }

    /** By IEC 61966-2-1 a sample of 0.5 is 0.21404 of white. A reduced pixel is the mean of light, not of samples. */
    @Test
    void lightIsLinearBeforePixelsBecomeFewer() throws IOException {
        int half = 32_768;
        int one = 65_535;
        // Red and green; blue and a transparent white.
        int[] samples = {half, 0, 0, one, 0, half, 0, one, 0, 0, half, one, one, one, one, 0};
        png(2, RGBA, new byte[0], samples);
        Photograph.Linear pixels = whole();
        float[] luminances = {0.2126729f, 0.7151522f, 0.0721750f};
        for (int c = 0; c < 3; c++) {
            assertThat(luminance(pixels, c)).isEqualTo(luminances[c] * 0.21405f, EXACT);
        }
        assertThat(pixels.picture().rgba()[4 * 3 + 3]).as("transparent").isZero();
        Photograph.Linear mean = Photograph.read(file).reduced(1, 1);
        assertThat(luminance(mean, 0)).isEqualTo(0.25f * 0.21405f, EXACT);
        assertThat(mean.picture().rgba()[3]).isEqualTo(0.75f, EXACT);
        assertThat(mean.clipped()[0]).isTrue();

        // Three columns of 0, 1, 0 become two columns of a third each.
        png(3, GRAY, new byte[0], 0, one, 0);
        Photograph.Linear two = Photograph.read(file).reduced(2, 1);
        assertThat(luminance(two, 0)).isEqualTo(1 / 3f, EXACT);
        assertThat(luminance(two, 1)).isEqualTo(1 / 3f, EXACT);
    }

    /** The profile of linear light has sRGB's primaries: half of a sample is half of the light, its white that of D65. */
    @Test
    void aProfileSaysWhatSamplesMean() throws IOException {
        png(1, RGB, profile(ColorSpace.CS_LINEAR_RGB), 32_768, 32_768, 32_768, 32_768, 0, 0);
        Photograph.Linear photo = whole();
        // Profiles store 16-bit numbers, among them a rounded D50.
        Offset<Float> profiled = within(5e-4f);
        assertThat(photo.picture().rgba()[0]).isEqualTo(0.5f * 0.95047f, profiled);
        assertThat(luminance(photo, 0)).isEqualTo(0.5f, profiled);
        assertThat(photo.picture().rgba()[2]).isEqualTo(0.5f * 1.08883f, profiled);
        assertThat(luminance(photo, 1)).isEqualTo(0.5f * 0.2126729f, profiled);
        // Java's gray profile is linear.
        png(1, GRAY, profile(ColorSpace.CS_GRAY), 32_768);
        assertThat(luminance(whole(), 0)).isEqualTo(0.5f, profiled);
    }

    /** Photo YCC mixes its three channels. A red sample of 0.6 in sRGB has 0.3185 of the light. */
    @Test
    void aProfileMayMixChannels() throws IOException {
        byte[] profile = profile(ColorSpace.CS_PYCC);
        float[] mixed = ColorSpace.getInstance(ColorSpace.CS_PYCC).fromRGB(new float[] {0.6f, 0, 0});
        int[] samples =
                IntStream.range(0, 3).map(c -> Math.round(65_535 * mixed[c])).toArray();
        png(1, RGB, profile, samples);
        // Both conversions have 8-bit tables: three steps at 0.6 are 3 % of light.
        assertThat(luminance(whole(), 0)).isEqualTo(0.3185f * 0.2126729f, within(0.03f * 0.2126729f));
    }

    /** Truncated profiles and damaged headers, tag tables and tags end in one line, never in another exception. */
    @Test
    void damagedProfilesAreRefusedInOneLine() throws IOException {
        byte[] good = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
        for (int length = 0; length < good.length; length += good.length < 1000 ? 37 : 97) {
            png(1, RGB, profile(Arrays.copyOf(good, length)), 1, 2, 3);
            assertReadOrRefused("profile");
        }
        // Sizes, class, space, version, number of tags, places of tags.
        for (int at :
                new int[] {0, 3, 8, 12, 16, 20, 36, 64, 128, 131, 132, 136, 140, 143, 144, 160, good.length - 1}) {
            for (int value : new int[] {0, 0x7f, 0xff, 'C'}) {
                byte[] bad = good.clone();
                bad[at] = (byte) value;
                png(1, RGB, profile(bad), 1, 2, 3);
                assertReadOrRefused("profile");
            }
        }
        png(1, RGB, profile(Arrays.copyOf(good, 200)), 0, 0, 0);
        assertRefused("profile");
    }

    /** Decoders and Exif data cause no other exception. */
    @Test
    void damagedPhotographsAreReadOrRefused() throws IOException {
        Random random = new Random(1);
        byte[] good = png(2, RGB, chunk("eXIf", exif(8)), 1, 2, 3, 4, 5, 6);
        for (int mutation = 0; mutation < 100; mutation++) {
            byte[] bad = good.clone();
            // Do not damage the signature and the size.
            bad[24 + random.nextInt(bad.length - 24)] ^= (byte) (1 << random.nextInt(8));
            write(bad);
            assertReadOrRefused("; ");
        }
    }

    /** Java's TIFF decoder silently drops a damaged profile. */
    @Test
    void aTiffsDamagedProfileIsRefused() throws IOException {
        // Tag, type, count and value.
        String entries = """
                256 3 1 1, 257 3 1 1, 258 3 1 8, 259 3 1 1, 262 3 1 1, 273 4 1 8, 277 3 1 1, 278 3 1 1, 279 4 1 1,
                34675 7 100 150""";
        ByteBuffer tiff = ByteBuffer.allocate(250).order(ByteOrder.LITTLE_ENDIAN);
        tiff.put(new byte[] {'I', 'I', 42, 0, 10, 0, 0, 0, 77, 0, 10, 0});
        for (String entry : entries.split(",\\s*", -1)) {
            int[] n = Arrays.stream(entry.split(" ", -1))
                    .mapToInt(Integer::parseInt)
                    .toArray();
            tiff.putShort((short) n[0]).putShort((short) n[1]).putInt(n[2]).putInt(n[3]);
        }
        write(tiff.array());
        assertRefused("color profile that is damaged or does not fit");
        write(tiff.putShort(10, (short) 9).array());
        assertThat(whole().picture().rgba()[3]).as("without the last entry").isOne();
    }

    /** Asserts that the file is read, or refused in a line with these words. */
    private void assertReadOrRefused(String words) {
        try {
            assertThat(whole().picture().rgba()).doesNotContain(Float.NaN);
        } catch (InputException complaint) {
            assertThat(complaint).hasMessageContainingAll("photograph " + file, words);
        }
    }

    /** 2 MB with one bit per pixel would take minutes. Java's decoder fills the missing part of a JPEG with gray and only warns. */
    @Test
    void aPictureOfTooManyPixelsOrOfTooFewBytesIsRefused() throws IOException {
        write(written(new BufferedImage(16_384, 16_384, BufferedImage.TYPE_BYTE_BINARY), "png"));
        assertRefused("16384 x 16384 pixels; make it smaller, 160 million at most");
        byte[] jpeg = written(new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB), "jpeg");
        write(Arrays.copyOf(jpeg, jpeg.length - 20));
        assertRefused("is damaged (Truncated");
    }

    private void assertRefused(String... words) {
        assertThatThrownBy(this::whole)
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll("photograph " + file, "; ")
                .hasMessageContainingAll(words);
    }

    @Test
    void whatHasNoKnownColorsIsRefused() throws IOException {
        png(1, GRAY, profile(ColorSpace.CS_LINEAR_RGB), 0);
        assertRefused("1 channels of color and a profile for 3");
        png(1, RGB, chunk("gAMA", new byte[] {0, 1, (byte) 0x86, (byte) 0xa0}), 0, 0, 0);
        assertRefused("with gamma 1.0");
        png(1, RGB, chunk("cICP", new byte[] {9, 16, 0, 1}), 0, 0, 0);
        assertRefused("cICP");
        png(1, RGB, chunk("iCCP", new byte[] {'p', 0, 0, 1, 2}), 0, 0, 0);
        assertRefused("damaged");
        Files.writeString(file, "no picture");
        assertRefused("no PNG, JPEG");
    }
}
