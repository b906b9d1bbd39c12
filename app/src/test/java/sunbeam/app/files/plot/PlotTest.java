package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;

final class PlotTest {
    private static final int BLUE = 0xff0072b2;
    private static final int VERMILION = 0xffd55e00;

    @Test
    void seriesAreDrawnOnWhiteInColorsOfTheirOwn() {
        double[] terms = IntStream.rangeClosed(1, 40).asDoubleStream().toArray();
        double[] taylor = Arrays.stream(terms).map(n -> Math.exp(5 - 0.4 * n)).toArray();
        double[] chebyshev =
                Arrays.stream(terms).map(n -> Math.exp(1 - 0.6 * n)).toArray();
        Frame frame = new Frame("Error", Axis.linear("terms"), Axis.logarithmic("relative error of power"), 900, 600);

        BufferedImage image = new Plot(frame)
                .line("Taylor", terms, taylor)
                .points("Chebyshev", terms, chebyshev)
                .draw();

        assertThat(image.getWidth()).isEqualTo(900);
        assertThat(image.getHeight()).isEqualTo(600);
        assertThat(image.getRGB(0, 0)).isEqualTo(0xffffffff);
        assertThat(image.getRGB(0, 0, 900, 600, null, 0, 900)).contains(BLUE, VERMILION);
    }

    @Test
    void namesInALegendAreAlignedWhateverTheirMarks() {
        double[] values = {1, 2};
        Frame frame = new Frame("Error", Axis.linear("x"), Axis.linear("y"), 900, 600);

        BufferedImage image = new Plot(frame)
                .line("H", values, values)
                .points("H", values, values)
                .draw();

        // The names are the last ink of their rows, right of the axes.
        int[] ends = IntStream.range(0, image.getHeight())
                .map(y -> IntStream.range(850, image.getWidth())
                        .filter(x -> (image.getRGB(x, y) & 0xff) < 64)
                        .max()
                        .orElse(0))
                .filter(end -> end > 0)
                .distinct()
                .toArray();
        assertThat(ends).hasSize(1);
    }
}
