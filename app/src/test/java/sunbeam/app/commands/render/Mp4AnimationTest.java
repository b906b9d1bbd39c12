package sunbeam.app.commands.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.Overwrite;

class Mp4AnimationTest {
    private static final int[] COLORS = {0xc03020, 0x20a040, 0x3050d0};

    @TempDir
    private Path folder;

    @BeforeEach
    void requireFfmpeg() {
        boolean found = false;
        for (String place : System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1)) {
            found |= !place.isEmpty() && Files.isExecutable(Path.of(place, "ffmpeg"));
        }
        assumeTrue(found, "ffmpeg is not on the PATH: MP4 animations are not tested");
    }

    /** Frames of odd sides, in one color each. */
    private List<Path> frames() throws IOException {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < COLORS.length; i++) {
            BufferedImage image = new BufferedImage(65, 49, BufferedImage.TYPE_INT_RGB);
            for (int pixel = 0; pixel < 65 * 49; pixel++) {
                image.setRGB(pixel % 65, pixel / 65, COLORS[i]);
            }
            Path file = folder.resolve("frame-000" + (i + 1) + ".png");
            ImageIO.write(image, "png", file.toFile());
            files.add(file);
        }
        return files;
    }

    @Test
    void everyFrameIsThereInItsColor() throws Exception {
        Path target = folder.resolve("animation.mp4");
        Mp4Animation.write(target, Overwrite.REFUSE, frames(), 12.5);

        Process decoder = new ProcessBuilder(
                        "ffmpeg", "-nostdin", "-loglevel", "error", "-i", target.toString(), folder + "/decoded-%d.png")
                .redirectErrorStream(true)
                .start();
        assertThat(new String(decoder.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .isEmpty();
        assertThat(decoder.waitFor()).isZero();
        assertThat(folder.resolve("decoded-" + (COLORS.length + 1) + ".png")).doesNotExist();
        for (int i = 0; i < COLORS.length; i++) {
            BufferedImage decoded =
                    ImageIO.read(folder.resolve("decoded-" + (i + 1) + ".png").toFile());
            assertThat(decoded.getWidth()).isEqualTo(66);
            for (int shift = 0; shift <= 16; shift += 8) {
                // 8 bits of luma and chroma in the narrow range, and the encoder's loss: a few steps of 255.
                assertThat(decoded.getRGB(32, 24) >> shift & 0xff)
                        .as("color %06x of frame %d", COLORS[i], i)
                        .isCloseTo(COLORS[i] >> shift & 0xff, within(6));
            }
        }
    }
}
