package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

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
    private static final int RING = 0xff222222;

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
                "Error over the number of terms", Axis.linear("terms"), Axis.logarithmic("relative error of power"));
        return new Plot(frame).line("Taylor", terms, taylor).lineWithPoints("Chebyshev", terms, chebyshev);
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
    void ringsAreBlackAndLeaveWhatTheySurroundInSight() {
        double[] place = {20};
        double[] error = {1e-2};
        Frame frame = new Frame("t", Axis.linear("x"), Axis.logarithmic("y"));
        double[] x = {1, 20, 40};
        double[] y = {1, 1e-2, 1e-4};
        BufferedImage without =
                new Plot(frame).points("a", x, y).points("b", place, error).draw();
        BufferedImage with =
                new Plot(frame).points("a", x, y).rings("b", place, error).draw();
        // The mark in the middle, 8 pixels wide, is covered by a mark but not by a ring.
        assertThat(count(with, BLUE)).isGreaterThan(count(without, BLUE));
        assertThat(count(with, RING)).isGreaterThan(count(without, RING));
    }

    private static int count(BufferedImage image, int color) {
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += image.getRGB(x, y) == color ? 1 : 0;
            }
        }
        return count;
    }

    @Test
    void aLineOfEqualValuesAndASinglePointAreDrawn() {
        Frame frame = new Frame("t", Axis.logarithmic("x"), Axis.logarithmic("y"));
        BufferedImage image = new Plot(frame)
                .points("one", new double[] {3}, new double[] {1e-4})
                .draw();
        assertThat(colors(image)).contains(BLUE);
    }

    @Test
    void theFileSaysHowItWasMade() {
        Path target = folder.resolve("plot.png");
        errors().write(target, Overwrite.REFUSE, Map.of("patch", "blaze"));
        assertThat(PngText.read(target)).containsEntry("patch", "blaze").containsKey("Software");
    }

    @Test
    void whatHasNoPlaceOnAnAxisIsRefused() {
        Plot plot = new Plot(new Frame("t", Axis.linear("x"), Axis.logarithmic("y")));
        assertThatThrownBy(() -> plot.line("exact", new double[] {1, 2}, new double[] {1e-3, 0}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'exact': y = 0.0");
        assertThatThrownBy(() -> plot.line("gap", new double[] {1, Double.NaN}, new double[] {1, 1}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'gap': x = NaN");
        assertThatThrownBy(plot::draw).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void logarithmicTicksReadAsPowersOfTen() {
        assertThat(PlotStyle.powerOfTen(1e-5)).isEqualTo("1e-5");
        assertThat(PlotStyle.powerOfTen(1)).isEqualTo("1");
        assertThat(PlotStyle.powerOfTen(100)).isEqualTo("100");
        assertThat(PlotStyle.powerOfTen(1e6)).isEqualTo("1e6");
        assertThat(PlotStyle.powerOfTen(256)).isEqualTo("256");
        assertThat(PlotStyle.powerOfTen(2048)).isEqualTo("2048");
        assertThat(PlotStyle.powerOfTen(Math.pow(10, Math.log10(2e-2)))).isEqualTo("0.02");
    }

    @Test
    void aUnitIsAsLongAlongBothAxesWhereThatIsAskedFor() {
        double[] x = {0, 1, 1, 0, 0};
        double[] y = {0, 0, 1, 1, 0};
        Frame frame = new Frame("Square", Axis.linear("x"), Axis.linear("y"), 640, 400);
        BufferedImage image = new Plot(frame)
                .equalScales(0.5)
                .line("square", x, y, new Plot.Look(1, 0))
                .draw();
        int left = image.getWidth();
        int right = 0;
        int top = image.getHeight();
        int bottom = 0;
        for (int j = 0; j < image.getHeight(); j++) {
            for (int i = 0; i < image.getWidth(); i++) {
                if (image.getRGB(i, j) == VERMILION) {
                    left = Math.min(left, i);
                    right = Math.max(right, i);
                    top = Math.min(top, j);
                    bottom = Math.max(bottom, j);
                }
            }
        }
        assertThat(right - left).isGreaterThan(100);
        // Pixels at a line's border are blended.
        assertThat(right - left).isCloseTo(bottom - top, within(2));
    }
}
