package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.jfree.chart.ChartRenderingInfo;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;

final class HeatMapTest {
    private static HeatMap map(double[][] rows, HeatMap.Reduction reduction) {
        HeatMap.Colors colors = new HeatMap.Colors("value", 0, 1, Plot.Scale.LINEAR, HeatMap.ColorMap.GRAY);
        return new HeatMap(
                new HeatMap.Frame("", "x", "y", 800, 600, false),
                new HeatMap.Values(rows, new double[] {0, 10}, new double[] {0, 10}, colors, reduction));
    }

    private final ChartRenderingInfo places = new ChartRenderingInfo();

    private Rectangle2D area() {
        return places.getPlotInfo().getDataArea();
    }

    /** Gray level at a place of the matrix, 0..1 to the right and up. */
    private int gray(BufferedImage image, double x, double y) {
        int column = (int) (area().getX() + x * area().getWidth());
        int row = (int) (area().getMaxY() - y * area().getHeight());
        return image.getRGB(column, row) & 0xFF;
    }

    @Test
    void rowsGoUpAndColumnsGoRight() {
        BufferedImage image = map(new double[][] {{0, 1}, {0.5, 0}}, HeatMap.Reduction.LARGEST)
                .draw(places)
                .rasterize();
        assertThat(gray(image, 0.25, 0.25)).isZero();
        assertThat(gray(image, 0.75, 0.25)).isEqualTo(255);
        assertThat(gray(image, 0.25, 0.75)).isEqualTo(128);
        assertThat(gray(image, 0.75, 0.75)).isZero();
    }

    @Test
    void aThinRidgeIsNotLostBetweenPixels() {
        double[][] rows = new double[4][20_000];
        for (double[] row : rows) {
            row[10_003] = 1;
        }
        assertThat(whitePixelsAcross(
                        map(rows, HeatMap.Reduction.LARGEST).draw(places).rasterize()))
                .isPositive();
        assertThat(whitePixelsAcross(
                        map(rows, HeatMap.Reduction.MIDDLE).draw(places).rasterize()))
                .isZero();
    }

    private long whitePixelsAcross(BufferedImage image) {
        return IntStream.range((int) area().getX() + 2, (int) area().getMaxX() - 2)
                .filter(x -> (image.getRGB(x, (int) area().getCenterY()) & 0xFF) == 255)
                .count();
    }

    @Test
    void logarithmicColorsSpanTheirDecadesEvenly() {
        HeatMap.Colors colors = new HeatMap.Colors("", 1e-4, 1, Plot.Scale.LOGARITHMIC, HeatMap.ColorMap.VIRIDIS);
        assertThat(colors.position(1e-2)).isEqualTo(0.5);
        assertThat(colors.position(0)).isZero();
        assertThat(colors.position(1)).isEqualTo(1);
    }

    @Test
    void aShortLogarithmicAxisHasSeveralLabels() {
        double[] errors = {1.2e-4, 1.3e-4};
        BufferedImage image = new Plot(new Frame("", Axis.linear("x"), Axis.logarithmic("y"), 800, 600))
                .points("", errors, errors)
                .draw()
                .rasterize();
        IntStream gridLines = IntStream.range(1, 600)
                .filter(y -> image.getRGB(403, y) != image.getRGB(403, y - 1) && image.getRGB(403, y) == 0xffdddddd);
        assertThat(gridLines.count()).isBetween(2L, 3L);
    }

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
                .draw()
                .rasterize();

        assertThat(image.getWidth()).isEqualTo(900);
        assertThat(image.getHeight()).isEqualTo(600);
        assertThat(image.getRGB(0, 0)).isEqualTo(0xffffffff);
        assertThat(image.getRGB(0, 0, 900, 600, null, 0, 900)).contains(BLUE, VERMILION);
    }
}
