package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.PngText;
import sunbeam.precompute.files.InputException;

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
}
