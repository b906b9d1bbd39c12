package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import sunbeam.app.scene.SceneSettings;

/** Compares pictures of the test scene. */
final class Pictures {
    private Pictures() {}

    /** Returns the number of pixels that differ in color or, with {@code silhouette}, in whether they show the background. */
    static int different(BufferedImage one, BufferedImage other, boolean silhouette) {
        assertThat(other.getWidth()).isEqualTo(one.getWidth());
        assertThat(other.getHeight()).isEqualTo(one.getHeight());
        int background = 0xff000000
                | ViewerInAWindow.scene().get(SceneSettings.BACKGROUND).rgb();
        int count = 0;
        for (int y = 0; y < one.getHeight(); y++) {
            for (int x = 0; x < one.getWidth(); x++) {
                int a = one.getRGB(x, y);
                int b = other.getRGB(x, y);
                boolean differs = silhouette ? (a == background) != (b == background) : a != b;
                count += differs ? 1 : 0;
            }
        }
        return count;
    }

    /** Returns the number of colored pixels. */
    static int spectralPixels(BufferedImage image) {
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                Color color = new Color(image.getRGB(x, y));
                int most = Math.max(color.getRed(), Math.max(color.getGreen(), color.getBlue()));
                int least = Math.min(color.getRed(), Math.min(color.getGreen(), color.getBlue()));
                count += most - least > 60 ? 1 : 0;
            }
        }
        return count;
    }

    static int shownPixels(BufferedImage image) {
        BufferedImage empty = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_RGB);
        int background = ViewerInAWindow.scene().get(SceneSettings.BACKGROUND).rgb();
        for (int i = 0; i < empty.getWidth() * empty.getHeight(); i++) {
            empty.setRGB(i % empty.getWidth(), i / empty.getWidth(), background);
        }
        return different(image, empty, true);
    }
}
