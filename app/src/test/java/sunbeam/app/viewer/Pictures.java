package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;

/** Pixels of pictures, and files of patches. */
final class Pictures {
    private static final int BACKGROUND =
            0xff000000 | ViewerInAWindow.scene().background().rgb();

    private Pictures() {}

    /** Returns the number of pixels that differ in color or, with {@code silhouette}, in whether they show the background. */
    static int different(BufferedImage one, BufferedImage other, boolean silhouette) {
        assertThat(other.getWidth()).isEqualTo(one.getWidth());
        assertThat(other.getHeight()).isEqualTo(one.getHeight());
        int[] first = pixels(one);
        int[] second = pixels(other);
        return (int) IntStream.range(0, first.length)
                .filter(i -> silhouette ? (first[i] == BACKGROUND) != (second[i] == BACKGROUND) : first[i] != second[i])
                .count();
    }

    /** Returns all pixels as 0xffRRGGBB. */
    static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    static int spectralPixels(BufferedImage image) {
        return (int) Arrays.stream(pixels(image))
                .mapToObj(Color::new)
                .mapToInt(color -> Math.max(color.getRed(), Math.max(color.getGreen(), color.getBlue()))
                        - Math.min(color.getRed(), Math.min(color.getGreen(), color.getBlue())))
                .filter(difference -> difference > 60)
                .count();
    }

    static int shownPixels(BufferedImage image) {
        return (int)
                Arrays.stream(pixels(image)).filter(rgb -> rgb != BACKGROUND).count();
    }

    private static final int SIDE = 32;

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
