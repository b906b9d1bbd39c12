package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.PngText;
import sunbeam.precompute.files.InputException;

/** Pictures and their text, tables and arrays, as other programs read them. */
final class PngWriterTest {
    private static final int[] PIXELS = {0xff000000, 0xffff8001, 0xff0080ff, 0xffffffff, 0xff123456, 0xfffedcba};

    @TempDir
    private Path folder;

    private static BufferedImage image() {
        BufferedImage image = new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 3, 2, PIXELS, 0, 3);
        return image;
    }

    private Path write(BufferedImage image, Map<String, String> text) {
        Path target = folder.resolve("out.png");
        PngWriter.write(target, Overwrite.REFUSE, image, text);
        return target;
    }

    @Test
    void pixelsComeBackExactlyMarkedAsSrgb() throws IOException {
        Path file = write(image(), Map.of());
        BufferedImage image = ImageIO.read(file.toFile());
        assertThat(image.getColorModel().hasAlpha()).isFalse();
        assertThat(image.getRGB(0, 0, 3, 2, null, 0, 3)).isEqualTo(PIXELS);
        assertThat(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1))
                .contains("sRGB\0");
    }

    @Test
    void textsComeBackInAnyLanguageAndTheirOrder() {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("theta-i", "75 deg");
        text.put("Comment", "two\nlines, 65 \u00b5m");
        text.put("patch", "\u86c7 \u03bb/4");
        Path file = write(image(), text);
        Map<String, String> read = PngText.read(file);
        assertThat(read).containsAllEntriesOf(text);
        assertThat(read.get("Software")).startsWith("Sunbeam ");
        assertThat(read.keySet()).startsWith("Software", "theta-i", "Comment");
    }

    @Test
    void aFlippedBitInATextIsFound() throws IOException {
        Path file = write(image(), Map.of("patch", "blaze"));
        byte[] bytes = Files.readAllBytes(file);
        int position = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("blaze");
        bytes[position] ^= 1;
        Files.write(file, bytes);
        assertThatThrownBy(() -> PngText.read(file))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("checksum");
    }

    @Test
    void thirteenDigitsComeBack() throws IOException {
        double[] values = {Math.PI, -1.2345678901234567e-200, Double.MAX_VALUE / 3, 0};
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        CsvWriter.numbers(List.of("x"), values.length, row -> new double[] {values[row]})
                .writeTo(stream);
        List<String> read = stream.toString(StandardCharsets.UTF_8).lines().toList();
        for (int row = 0; row < values.length; row++) {
            assertThat(Double.parseDouble(read.get(row + 1)))
                    .isCloseTo(values[row], withinPercentage(5e-11)); // half of the 13th digit
        }
    }

    // Matrices of sRGB have seven digits.
    private static final float ROUNDING = 1e-5f;

    /** The red primary of Rec. 709. */
    @Test
    void openExrHasRedAsOne() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        LinearFile.of(Path.of("a.exr"), new float[] {0.4124564f, 0.2126729f, 0.0193339f}, 1, 1)
                .writeTo(stream);

        ByteBuffer bytes = ByteBuffer.wrap(stream.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);

        assertThat(bytes.getInt(0)).as("OpenEXR's magic number").isEqualTo(20000630);
        // A line this short is stored uncompressed, its channels in the order of the alphabet.
        float[] stored = new float[4];
        bytes.position(bytes.capacity() - 4 * Float.BYTES)
                .slice()
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(stored);
        assertThat(stored).containsExactly(new float[] {1, 0, 0, 1}, within(ROUNDING));
    }

    private static final String HASH = "0123";

    private Path picture() {
        Path file = folder.resolve("picture.png");
        BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
        PngWriter.write(file, Overwrite.REPLACE, image, Map.of(PngText.PARAMETERS, HASH));
        return file;
    }

    @Test
    void aPictureIsKnownByTheHashOfWhatDeterminesIt() {
        assertThat(PngText.find(picture(), HASH)).isPresent();
        assertThat(PngText.find(picture(), "4567")).isEmpty();
        assertThat(PngText.find(folder.resolve("none.png"), HASH)).isEmpty();
    }

    @Test
    void aPictureWithDamagedPixelsIsNotThePicture() throws IOException {
        Path file = picture();
        byte[] bytes = Files.readAllBytes(file);
        int pixels = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("IDAT") + 4;
        bytes[pixels + 8] ^= 1;
        Files.write(file, bytes);

        assertThat(PngText.find(file, HASH)).isEmpty();
    }
}
