package sunbeam.app.viewer.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

final class MapLabelsTest {
    @Test
    void labelsAreWholeAndCoverNoOther() {
        Rectangle bounds = new Rectangle(200, 200);
        Graphics2D graphics = new BufferedImage(200, 200, BufferedImage.TYPE_INT_RGB).createGraphics();
        MapLabels labels = new MapLabels(graphics, bounds);
        Random random = new Random(5);
        List<Rectangle2D> places = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            Rectangle2D place = labels.paint("+12", 200 * random.nextDouble(), 200 * random.nextDouble());
            if (place != null) {
                assertThat(bounds.contains(place)).isTrue();
                assertThat(places).noneMatch(place::intersects);
                places.add(place);
            }
        }
        assertThat(places).hasSizeGreaterThan(20);
        assertThat(new MapLabels(graphics, bounds).paint("x", 198, 100))
                .as("turns away from the edge")
                .isNotNull();
    }
}
