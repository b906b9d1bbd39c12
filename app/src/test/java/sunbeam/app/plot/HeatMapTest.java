package sunbeam.app.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
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

    /** Grey level in the middle of a cell of a 2 x 2 matrix over the plot's area. */
    private static int grey(BufferedImage image, double x, double y) {
        // The area's edges are where the border is drawn: left 92, right 118, top 48, bottom 66 pixels.
        int column = (int) (92 + x * (WIDTH - 92 - 118));
        int row = (int) (HEIGHT - 66 - y * (HEIGHT - 48 - 66));
        return image.getRGB(column, row) & 0xFF;
    }

    @Test
    void rowsGoUpAndColumnsGoRight() {
        BufferedImage image = map(new double[][] {{0, 1}, {0.5, 0}}, HeatMap.Reduction.LARGEST)
                .draw();
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
        assertThat(whitePixelsAcross(map(rows, HeatMap.Reduction.LARGEST).draw()))
                .isEqualTo(1);
        assertThat(whitePixelsAcross(map(rows, HeatMap.Reduction.MIDDLE).draw()))
                .isZero();
    }

    private static int whitePixelsAcross(BufferedImage image) {
        int count = 0;
        for (int x = 94; x < WIDTH - 120; x++) {
            count += (image.getRGB(x, HEIGHT / 2) & 0xFF) == 255 ? 1 : 0;
        }
        return count;
    }

    @Test
    void curvesLieOnTheirValues() {
        BufferedImage image = map(new double[][] {{0}}, HeatMap.Reduction.LARGEST)
                .curve("level", new double[] {0, 10}, new double[] {7.5, 7.5}, 0xFFFFFF, false)
                .draw();
        int row = HEIGHT - 66 - 28 - (int) Math.round(0.75 * (HEIGHT - 48 - 66 - 28));
        assertThat(image.getRGB(200, row) & 0xFF).isGreaterThan(150);
        assertThat(image.getRGB(200, row + 10) & 0xFF).isZero();
    }

    @Test
    void logarithmicColoursSpanTheirDecadesEvenly() {
        HeatMap.Colors colors = new HeatMap.Colors("", 1e-4, 1, Plot.Scale.LOGARITHMIC, ColorMap.VIRIDIS);
        assertThat(colors.position(1e-2)).isEqualTo(0.5);
        assertThat(colors.position(0)).isZero();
        assertThat(colors.position(1)).isEqualTo(1);
    }

    @Test
    void coloursGrowLighter() {
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

    @Test
    void ticksAreRound() {
        assertThat(Ticks.between(380, 780, 8).values()).containsExactly(400, 450, 500, 550, 600, 650, 700, 750);
        Ticks fine = Ticks.between(-0.25, 0.31, 6);
        assertThat(fine.values()[0]).isEqualTo(-0.2);
        assertThat(fine.label(0)).isEqualTo("-0.2");
        assertThat(Ticks.powersOfTen(2e-5, 0.5).values()).containsExactly(1e-4, 1e-3, 1e-2, 1e-1);
    }
}
