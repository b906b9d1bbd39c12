package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

final class PatchFiles {
    private static final int SIDE = 32;

    private PatchFiles() {}

    /** One period of a cosine, 2 um wide and 300 nm deep: other colors and another plan than blaze's. */
    static Path descriptor(Path folder, String name) throws IOException {
        image(folder, name + ".png");
        Path file = folder.resolve(name + ".json");
        Files.writeString(
                file, "{\"heights\": \"%s.png\", \"width\": \"2 um\", \"maxHeight\": \"300 nm\"}".formatted(name));
        return file;
    }

    static Path image(Path folder, String name) throws IOException {
        BufferedImage heights = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_BYTE_GRAY);
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                double height = 0.5 + 0.5 * Math.cos(2 * Math.PI * x / SIDE);
                heights.getRaster().setSample(x, y, 0, (int) Math.round(255 * height));
            }
        }
        Path file = folder.resolve(name);
        ImageIO.write(heights, "png", file.toFile());
        return file;
    }
}
