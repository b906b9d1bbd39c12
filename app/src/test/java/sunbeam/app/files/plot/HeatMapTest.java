package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import org.jfree.chart.ChartRenderingInfo;
import org.junit.jupiter.api.Test;

final class HeatMapTest {
    private static final int WIDTH = 500;
    private static final int HEIGHT = 400;

    private static HeatMap map(double[][] rows, HeatMap.Reduction reduction) {
        HeatMap.Colors colors = new HeatMap.Colors("value", 0, 1, Plot.Scale.LINEAR, ColorMap.GREY);
        return new HeatMap(
                new HeatMap.Frame("", "x", "y", WIDTH, HEIGHT, false),
                new HeatMap.Values(rows, new double[] {0, 10}, new double[] {0, 10}, colors, reduction));
    }

    private final ChartRenderingInfo places = new ChartRenderingInfo();

    private Rectangle2D area() {
        return places.getPlotInfo().getDataArea();
    }

    /** Grey level at a place of the matrix, 0..1 to the right and up. */
    private int grey(BufferedImage image, double x, double y) {
        int column = (int) (area().getX() + x * area().getWidth());
        int row = (int) (area().getMaxY() - y * area().getHeight());
        return image.getRGB(column, row) & 0xFF;
    }

    @Test
    void rowsGoUpAndColumnsGoRight() {
        BufferedImage image = map(new double[][] {{0, 1}, {0.5, 0}}, HeatMap.Reduction.LARGEST)
                .draw(places);
        assertThat(grey(image, 0.25, 0.25)).isZero();
        assertThat(grey(image, 0.75, 0.25)).isEqualTo(255);
        assertThat(grey(image, 0.25, 0.75)).isEqualTo(128);
        assertThat(grey(image, 0.75, 0.75)).isZero();
    }

    @Test
    void aThinRidgeIsNotLostBetweenPixels() {
        double[][] rows = new double[4][20_000];
        for (double[] row : rows) {
            row[10_003] = 1;
        }
        assertThat(whitePixelsAcross(map(rows, HeatMap.Reduction.LARGEST).draw(places)))
                .isEqualTo(1);
        assertThat(whitePixelsAcross(map(rows, HeatMap.Reduction.MIDDLE).draw(places)))
                .isZero();
    }

    private int whitePixelsAcross(BufferedImage image) {
        int count = 0;
        for (int x = (int) area().getX() + 2; x < area().getMaxX() - 2; x++) {
            count += (image.getRGB(x, (int) area().getCenterY()) & 0xFF) == 255 ? 1 : 0;
        }
        return count;
    }

    @Test
    void intervalsLeaveInSightWhatLiesWithinAndEndWhereOneSideIsUnknown() {
        double[] x = {0, 5, 10};
        BufferedImage image = map(new double[][] {{0.5}}, HeatMap.Reduction.LARGEST)
                .interval(
                        "level",
                        x,
                        new double[] {5, 5, Double.NaN},
                        new double[] {7, 7, 7},
                        new double[] {4, 4, 4},
                        0xFFFFFF)
                .draw(places);
        int cell = grey(image, 0.25, 0.9);
        assertThat(List.of(grey(image, 0.25, 0.6), grey(image, 0.25, 0.45), grey(image, 0.25, 0.75)))
                .containsOnly(cell);
        assertThat(grey(image, 0.25, 0.5)).isGreaterThan(cell + 50);
        // Dots and gaps of the sides, white with dark rims.
        assertThat(brightest(image, 0.7)).isGreaterThan(cell + 50);
        assertThat(brightest(image, 0.4)).isGreaterThan(cell + 50);
        assertThat(darkest(image, 0.5)).as("the rim of the curve").isLessThan(cell - 50);
        assertThat(grey(image, 0.75, 0.5)).isEqualTo(cell);
        assertThat(grey(image, 0.75, 0.7)).isEqualTo(cell);
    }

    private int brightest(BufferedImage image, double y) {
        return nearby(image, y).max().orElseThrow();
    }

    private int darkest(BufferedImage image, double y) {
        return nearby(image, y).min().orElseThrow();
    }

    /** Left of the middle, up to three pixels above and below. */
    private IntStream nearby(BufferedImage image, double y) {
        int row = (int) Math.round(area().getMaxY() - y * area().getHeight());
        return IntStream.range(0, 20 * 7)
                .map(i -> image.getRGB((int) (area().getMinX() + 0.2 * area().getWidth()) + i / 7, row - 3 + i % 7)
                        & 0xFF);
    }

    @Test
    void curvesLieOnTheirValues() {
        BufferedImage image = map(new double[][] {{0}}, HeatMap.Reduction.LARGEST)
                .curve("level", new double[] {0, 10}, new double[] {7.5, 7.5}, 0xFFFFFF, false)
                .draw(places);
        assertThat(grey(image, 0.4, 0.75)).isGreaterThan(150);
        assertThat(grey(image, 0.4, 0.7)).isZero();
    }

    @Test
    void aUnitIsAsLongAlongBothAxesWhereThatIsAskedFor() {
        HeatMap.Colors colors = new HeatMap.Colors("value", 0, 1, Plot.Scale.LINEAR, ColorMap.GREY);
        HeatMap.Frame frame = new HeatMap.Frame("title", "x", "y", WIDTH, HEIGHT, true);
        HeatMap.Values values = new HeatMap.Values(
                new double[][] {{0}}, new double[] {0, 3}, new double[] {0, 1}, colors, HeatMap.Reduction.LARGEST);
        new HeatMap(frame, values).draw(places);
        // The corners of the area are whole pixels.
        assertThat(area().getHeight()).isCloseTo(area().getWidth() / 3, within(2.0));
    }

    @Test
    void theColorBarIsAsHighAsTheMatrix() {
        BufferedImage image =
                map(new double[][] {{0.5}}, HeatMap.Reduction.LARGEST).draw(places);
        // Left of it is the gap, right of it are the ticks.
        int bar = (int) area().getMaxX() + 12 + 9;
        assertThat(image.getRGB(bar, (int) area().getMinY() + 3) & 0xFF).isGreaterThan(250);
        assertThat(image.getRGB(bar, (int) area().getMaxY() - 3) & 0xFF).isLessThan(5);
        assertThat(image.getRGB(bar, (int) area().getMaxY() + 4) & 0xFF).isEqualTo(255);
    }

    @Test
    void logarithmicColorsSpanTheirDecadesEvenly() {
        HeatMap.Colors colors = new HeatMap.Colors("", 1e-4, 1, Plot.Scale.LOGARITHMIC, ColorMap.VIRIDIS);
        assertThat(colors.position(1e-2)).isEqualTo(0.5);
        assertThat(colors.position(0)).isZero();
        assertThat(colors.position(1)).isEqualTo(1);
    }

    @Test
    void colorsGrowLighter() {
        double before = -1;
        for (int i = 0; i <= 50; i++) {
            int color = ColorMap.VIRIDIS.at(i / 50.0);
            double luma = 0.2126 * (color >> 16) + 0.7152 * (color >> 8 & 0xFF) + 0.0722 * (color & 0xFF);
            assertThat(luma).isGreaterThan(before);
            before = luma;
        }
        assertThat(ColorMap.VIRIDIS.at(-3)).isEqualTo(0x440154);
        assertThat(ColorMap.VIRIDIS.at(7)).isEqualTo(0xFDE725);
    }
}
