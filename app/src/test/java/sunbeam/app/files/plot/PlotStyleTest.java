package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class PlotStyleTest {
    @ParameterizedTest
    @CsvSource({
        "position / um, position / \u00b5m",
        "65 um x 65 um, 65 \u00b5m \u00d7 65 \u00b5m",
        "2.5um, 2.5\u00b5m",
        "nm^2 um, nm\u00b2 \u00b5m",
        "time / us, time / \u00b5s",
        "direction -0.4 +- 0.5, direction \u22120.4 \u00b1 0.5",
        "order (-1 -2), order (\u22121 \u22122)",
        "tolerance 1e-3, tolerance 10\u207b\u00b3",
        "10^-12, 10\u207b\u00b9\u00b2",
        "sum of us and scan-3, sum of us and scan-3",
        "2026-11-28, 2026-11-28"
    })
    void asciiBecomesPrint(String ascii, String print) {
        assertThat(PlotStyle.typeset(ascii)).isEqualTo(print);
    }

    @Test
    void theFontHasWhatPrintNeeds() {
        String text =
                "\u00b5\u2212\u00b1\u00d7\u00b0\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079\u207b\u207f\u2026\u00b7\u03b8\u03bb\u2192";
        assertThat(PlotFont.plain(8).canDisplayUpTo(text)).isEqualTo(-1);
        assertThat(PlotFont.bold(8).canDisplayUpTo(text)).isEqualTo(-1);
        assertThat(PlotFont.with(PlotFont.plain(8), "\u9cde").getFamily())
                .isNotEqualTo(PlotFont.plain(8).getFamily());
    }

    /** Colors in deuteranopia (Vi\u00e9not, Brettel, Mollon 1999): the response of the middle cones follows from the others'. */
    private static double[] deuteranope(Color color) {
        double[] c = IntStream.of(color.getRed(), color.getGreen(), color.getBlue())
                .mapToDouble(v -> Math.pow(v / 255.0, 2.2))
                .toArray();
        return new double[] {
            Math.cbrt(17.8824 * c[0] + 43.5161 * c[1] + 4.11935 * c[2]),
            Math.cbrt(0.02996 * c[0] + 0.18431 * c[1] + 1.46709 * c[2])
        };
    }

    @Test
    void twoLinesOfAPlotDifferForColorBlindReaders() {
        for (int i = 0; i < 14; i++) {
            for (int j = 0; j < i; j++) {
                double[] a = deuteranope(PlotStyle.color(i));
                double[] b = deuteranope(PlotStyle.color(j));
                boolean sameStroke = PlotStyle.lineStroke(i).equals(PlotStyle.lineStroke(j));
                // 0.1 of cube roots from 0 to 4 is a just noticeable difference many times over.
                boolean sameColor = Math.hypot(a[0] - b[0], a[1] - b[1]) < 0.1;
                assertThat(sameStroke && sameColor).as("%d and %d", i, j).isFalse();
            }
        }
    }

    @Test
    void twoSeriesOfPointsDifferInColorOrMark() {
        Set<String> seen = new HashSet<>();
        for (int i = 0; i < 14; i++) {
            assertThat(seen.add(PlotStyle.color(i) + " " + System.identityHashCode(PlotStyle.shape(i))))
                    .as("%d", i)
                    .isTrue();
        }
    }

    @Test
    void labelsOfLogarithmicAxesAreCenteredBesideTheirTicks() {
        Plot.Axis decades = Plot.Axis.logarithmic("");
        Plot plot = new Plot(new Plot.Frame("", Plot.Axis.linear(""), decades, 700, 500));
        BufferedImage image = plot.line("", new double[] {0, 1}, new double[] {0.01, 100})
                .draw()
                .rasterize();
        IntPredicate isAxis =
                x -> IntStream.range(0, 500).filter(y -> isDark(image, x, y)).count() > 250;
        int axis = IntStream.range(0, 700).filter(isAxis).findFirst().orElseThrow();
        int[] ticks = IntStream.range(1, 500)
                .filter(y -> isDark(image, axis - 4, y) && !isDark(image, axis - 4, y - 1))
                .toArray();

        assertThat(ticks).hasSizeGreaterThan(3);
        for (int tick : ticks) {
            int[] inked = IntStream.range(Math.max(0, tick - 25), Math.min(500, tick + 25))
                    .filter(y -> IntStream.range(0, axis - 12).anyMatch(x -> isDark(image, x, y)))
                    .toArray();
            // Ticks are two pixels thick, and digits are centered by the whole font's height.
            assertThat(0.5 * (inked[0] + inked[inked.length - 1])).isCloseTo(tick + 0.5, within(4.0));
        }
    }

    private static boolean isDark(BufferedImage image, int x, int y) {
        return (image.getRGB(x, y) & 0xff) < 0x80;
    }
}
