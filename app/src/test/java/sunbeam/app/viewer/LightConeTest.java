package sunbeam.app.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import org.joml.Vector3f;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LightConeTest {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 160;

    @ParameterizedTest
    @CsvSource({"0, 0, 1", "0.6, 0.3, 0.74", "-0.7, 0.7, 0.1", "0, -1, 0", "0.02, 0.03, -1"})
    void paintsNothingOutsideOfItsBounds(float x, float y, float z) {
        LightCone cone = new LightCone(new Vector3f(x, y, z).normalize());
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        cone.paint(image.createGraphics(), WIDTH, HEIGHT);
        Rectangle bounds = cone.bounds(WIDTH, HEIGHT);
        int painted = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                boolean dark = (image.getRGB(column, row) & 0xffffff) == 0;
                painted += dark ? 0 : 1;
                if (!bounds.contains(column, row)) {
                    assertTrue(dark, () -> cone + " beyond " + bounds);
                }
            }
        }
        assertTrue(painted > 0, "nothing was painted");
        assertEquals(bounds, new Rectangle(WIDTH, HEIGHT).intersection(bounds), "it goes beyond the picture");
    }
}
