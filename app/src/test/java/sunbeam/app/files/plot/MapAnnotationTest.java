package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.Direction;

class MapAnnotationTest {
    private static final int SIZE = 360;
    // Three lines of text, SIZE / 36 each.
    private static final int MARGIN = 30;
    private static final int LIGHT = 0xE69F00;
    private static final int MIRROR = 0x56B4E9;

    private static BufferedImage grey(int size) {
        BufferedImage map = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < size * size; i++) {
            map.setRGB(i % size, i / size, 0xff808080);
        }
        return map;
    }

    private static BufferedImage annotated(Direction light, String... caption) {
        return new MapAnnotation(grey(SIZE), light, List.of(caption)).draw();
    }

    /** The middle of the pixels of a color inside the map, as x and y of the disc; NaN without any. */
    private static double[] middle(BufferedImage image, int color) {
        double x = 0;
        double y = 0;
        int count = 0;
        for (int row = 0; row < SIZE; row++) {
            for (int column = 0; column < SIZE; column++) {
                if ((image.getRGB(MARGIN + column, MARGIN + row) & 0xffffff) == color) {
                    x += (2.0 * column + 1) / SIZE - 1;
                    y += 1 - (2.0 * row + 1) / SIZE;
                    count++;
                }
            }
        }
        return new double[] {x / count, y / count};
    }

    @Test
    void lightAndMirrorDirectionAreMarkedWhereTheyAre() {
        Direction light = Direction.ofDegrees(40, 70);

        BufferedImage image = annotated(light, "a caption");

        // Marks are symmetric; a pixel is 1/180 of the disc's radius.
        assertThat(middle(image, LIGHT)[0]).isBetween(light.x() - 0.01, light.x() + 0.01);
        assertThat(middle(image, LIGHT)[1]).isBetween(light.y() - 0.01, light.y() + 0.01);
        assertThat(middle(image, MIRROR)[0]).isBetween(-light.x() - 0.01, -light.x() + 0.01);
        assertThat(middle(image, MIRROR)[1]).isBetween(-light.y() - 0.01, -light.y() + 0.01);
    }

    @Test
    void theMapItselfIsUnchangedBetweenTheRings() {
        BufferedImage image = annotated(new Direction(0, 0, 1));

        // Between the rings of 45 and 60 degrees, away from their labels.
        int column = MARGIN + SIZE / 2 + (int) (SIZE / 2 * Math.sin(Math.toRadians(52)) * Math.cos(1));
        int row = MARGIN + SIZE / 2 + (int) (SIZE / 2 * Math.sin(Math.toRadians(52)) * Math.sin(1));
        assertThat(image.getRGB(column, row)).isEqualTo(0xff808080);
    }
}
