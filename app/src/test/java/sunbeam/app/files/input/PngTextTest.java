package sunbeam.app.files.input;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;

/** {@code figures} and {@code render --resume} keep only undamaged pictures with unchanged parameters. */
class PngTextTest {
    private static final String HASH = "0123";

    @TempDir
    Path folder;

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
