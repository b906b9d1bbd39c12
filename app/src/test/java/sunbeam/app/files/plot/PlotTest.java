package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;

final class PlotTest {
    private static final int BLUE = 0xff0072b2;
    private static final int VERMILION = 0xffd55e00;

    @TempDir
    private Path folder;

    private static Plot errors() {
        double[] terms = IntStream.rangeClosed(1, 40).asDoubleStream().toArray();
        double[] taylor = IntStream.rangeClosed(1, 40)
                .mapToDouble(n -> Math.exp(5 - 0.4 * n))
                .toArray();
        double[] chebyshev = IntStream.rangeClosed(1, 40)
                .mapToDouble(n -> Math.exp(1 - 0.6 * n))
                .toArray();
        Frame frame = new Frame(
                "Error over the number of terms",
                Axis.linear("terms"),
                Axis.logarithmic("relative error of power"),
                900,
                600);
        return new Plot(frame).line("Taylor", terms, taylor).points("Chebyshev", terms, chebyshev);
    }

    private static Set<Integer> colors(BufferedImage image) {
        Set<Integer> colors = new HashSet<>();
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                colors.add(image.getRGB(x, y));
            }
        }
        return colors;
    }

    @Test
    void seriesAreDrawnOnWhiteInColorsOfTheirOwn() {
        BufferedImage image = errors().draw();
        assertThat(image.getWidth()).isEqualTo(900);
        assertThat(image.getHeight()).isEqualTo(600);
        assertThat(image.getRGB(0, 0)).isEqualTo(0xffffffff);
        assertThat(colors(image)).contains(BLUE, VERMILION);
    }

    @Test
    void theFileSaysHowItWasMade() {
        Path target = folder.resolve("plot.png");
        errors().write(target, Overwrite.REFUSE, Map.of("patch", "blaze"));
        assertThat(PngText.read(target)).containsEntry("patch", "blaze").containsKey("Software");
    }
}
