package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class MapViewTest {
    private static final int SIDE = 100;

    private final MapView view = new MapView();

    MapViewTest() {
        view.setFont(new Font(Font.DIALOG, Font.PLAIN, 12));
        view.setSize(SIDE, SIDE + MapView.CAPTION);
        BufferedImage white = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = white.createGraphics();
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, SIDE, SIDE);
        graphics.dispose();
        view.show(white);
    }

    /** As a scroll pane has it painted that shows its upper rows only. */
    private BufferedImage painted(int rows) {
        BufferedImage screen = new BufferedImage(SIDE, SIDE + MapView.CAPTION, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = screen.createGraphics();
        graphics.clipRect(0, 0, SIDE, rows);
        view.paint(graphics);
        graphics.dispose();
        return screen;
    }

    @Test
    void nothingIsPaintedOutsideOfWhatAScrollPaneShows() {
        view.computed(1);
        BufferedImage screen = painted(SIDE / 2);
        assertThat(screen.getRGB(SIDE / 2, SIDE / 4) & 0xffffff).isEqualTo(0xffffff);
        assertThat(screen.getRGB(SIDE / 2, SIDE / 2 + 10) & 0xffffff).isZero();
    }

    @Test
    void anOldMapIsDimmedUntilTheNextOneIsComputed() {
        view.computed(0.4);
        assertThat(painted(SIDE).getRGB(SIDE / 2, SIDE / 2) & 0xff).isLessThan(0x80);
        view.computed(1);
        assertThat(painted(SIDE).getRGB(SIDE / 2, SIDE / 2) & 0xff).isEqualTo(0xff);
    }
}
