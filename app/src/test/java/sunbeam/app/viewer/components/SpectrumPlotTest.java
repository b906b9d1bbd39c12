package sunbeam.app.viewer.components;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

final class SpectrumPlotTest {
    private static final double[] POWERS = {0, 1, 0.5};

    @Test
    void aSpectrumThatIsBeingMadeIsSaidToComeUntilItIsThereOrFails() {
        SpectrumPlot plot = new SpectrumPlot();
        int[] without = painted(plot);
        plot.curves.get(0).await(true);
        assertThat(painted(plot)).isNotEqualTo(without);
        plot.curves.get(0).await(false);
        assertThat(painted(plot)).as("failed").isEqualTo(without);

        plot.curves.get(0).await(true);
        plot.curves.get(0).show(POWERS);
        SpectrumPlot other = new SpectrumPlot();
        other.curves.get(0).show(POWERS);
        assertThat(painted(plot)).as("there").isEqualTo(painted(other));
        plot.curves.get(1).await(true);
        assertThat(painted(plot)).as("a second one beside it").isNotEqualTo(painted(other));
    }

    @Test
    void theNumbersOfAMirrorHaveTheColorOfDaylight() {
        SpectrumPlot plot = new SpectrumPlot();
        double[] powers = new double[SpectrumPlot.COUNT];
        Arrays.fill(powers, 1);
        plot.curves.get(0).show(powers);
        // D65 by CIE 15, whose range of 360 to 830 nm adds nothing to four digits.
        assertThat(plot.numbers())
                .contains("XYZ, D65  0.950", ", 1.00000, 1.08", "\n380\t1.00000\n385\t", "\n780\t1.00000");
    }

    private static int[] painted(SpectrumPlot plot) {
        plot.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        plot.setForeground(Color.WHITE);
        plot.setSize(300, 100);
        BufferedImage image = new BufferedImage(300, 100, BufferedImage.TYPE_INT_RGB);
        Graphics graphics = image.createGraphics();
        plot.paint(graphics);
        graphics.dispose();
        return image.getRGB(0, 0, 300, 100, null, 0, 300);
    }
}
