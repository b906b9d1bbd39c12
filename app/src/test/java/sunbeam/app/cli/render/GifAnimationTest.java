package sunbeam.app.cli.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.Overwrite;

class GifAnimationTest {
    private static final int SIDE = 256;
    private static final int BLOCK = 16;

    @TempDir
    private Path folder;

    @Test
    void smoothColorsHaveNoBands() throws IOException {
        BufferedImage smooth = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            smooth.setRGB(x, y, x << 16 | y << 8 | (255 - x) / 2);
        }
        Path frame = folder.resolve("frame.png");
        ImageIO.write(smooth, "png", frame.toFile());
        Path target = folder.resolve("animation.gif");
        GifAnimation.write(target, Overwrite.REPLACE, List.of(frame), 10);

        BufferedImage drawn = ImageIO.read(target.toFile());
        double worst = 0;
        for (int block = 0; block < SIDE * SIDE / (BLOCK * BLOCK); block++) {
            double sum = 0;
            for (int i = 0; i < BLOCK * BLOCK; i++) {
                int x = BLOCK * (block % (SIDE / BLOCK)) + i % BLOCK;
                int y = BLOCK * (block / (SIDE / BLOCK)) + i / BLOCK;
                sum += (drawn.getRGB(x, y) >> 8 & 255) - (smooth.getRGB(x, y) >> 8 & 255);
            }
            worst = Math.max(worst, Math.abs(sum / (BLOCK * BLOCK)));
        }
        // The palette has steps of 32 codes, so without dither the blocks' means err by 9. At the edges dither loses
        // errors.
        assertThat(worst).isLessThan(4);
    }
}
