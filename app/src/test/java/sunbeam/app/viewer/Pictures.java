package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.app.scene.SceneSettings;

final class Pictures {
    private Pictures() {}

    /** Returns the number of pixels that differ in color or, with {@code silhouette}, in whether they show the background. */
    static int different(BufferedImage one, BufferedImage other, boolean silhouette) {
        assertThat(other.getWidth()).isEqualTo(one.getWidth());
        assertThat(other.getHeight()).isEqualTo(one.getHeight());
        int background = 0xff000000
                | ViewerInAWindow.scene().get(SceneSettings.BACKGROUND).rgb();
        int[] first = pixels(one);
        int[] second = pixels(other);
        return (int) IntStream.range(0, first.length)
                .filter(i -> silhouette ? (first[i] == background) != (second[i] == background) : first[i] != second[i])
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
        int background = 0xff000000
                | ViewerInAWindow.scene().get(SceneSettings.BACKGROUND).rgb();
        return (int)
                Arrays.stream(pixels(image)).filter(rgb -> rgb != background).count();
    }
}
