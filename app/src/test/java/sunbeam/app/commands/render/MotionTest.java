package sunbeam.app.commands.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import org.junit.jupiter.api.Test;

class MotionTest {
    @Test
    void sweepsHaveBothEndsAndWholeTurnsLeaveTheLastOut() {
        AngleSweep half = new AngleSweep(0, Math.PI);
        assertThat(half.at(4, 5)).isEqualTo(Math.PI);
        AngleSweep turn = new AngleSweep(0, 2 * Math.PI);
        assertThat(turn.at(3, 4)).isCloseTo(1.5 * Math.PI, within(1e-12));
        assertThat(half.at(0, 1)).isZero();
    }

    @Test
    void paletteKeepsFewColoursAsTheyAre() {
        BufferedImage image = new BufferedImage(4, 1, BufferedImage.TYPE_INT_RGB);
        int[] colors = {0xff0000, 0x102030, 0xfefefe, 0x000000};
        for (int x = 0; x < 4; x++) {
            image.setRGB(x, 0, colors[x]);
        }
        Palette palette = new Palette();
        palette.add(image);
        IndexColorModel chosen = palette.choose();
        BufferedImage applied = palette.apply(image, chosen);
        for (int x = 0; x < 4; x++) {
            assertThat(applied.getRGB(x, 0)).isEqualTo(0xff000000 | colors[x]);
        }
    }
}
