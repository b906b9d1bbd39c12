package sunbeam.app.commands.color;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

class ColorSheetTest {
    private static final CieTable CIE = CieTable.load();
    private static final MirrorReach REACH = new MirrorReach(CoherenceWindow.ofCoherenceLength(65e-6));
    private static final double EXPOSURE = 0.3;
    private static final String LONG = "Cicindela campestris, elytron 03 (museum no. 1907-221), left, 20 um, retrace";

    private static SeenColor seen(boolean along, double thetaR) {
        Direction wr = Direction.ofDegrees(Math.abs(thetaR), thetaR < 0 ? 180 : 0);
        SeenColor.View view = new SeenColor.View(along, 0, thetaR, new DirectionPair(Direction.ofDegrees(0, 0), wr));
        // Orange.
        return SeenColor.of(view, new double[] {0.6, 0.5, 0.1}, EXPOSURE, 1e-3, REACH, CIE);
    }

    private static ColorReport report(String name) {
        List<SeenColor> colours = Stream.of(true, false)
                .flatMap(along -> IntStream.rangeClosed(-8, 8).mapToObj(i -> seen(along, 10 * i)))
                .toList();
        SpectralWidth width = new SpectralWidth(30e-9, 590e-9, 580e-9, 600e-9, true);
        SeenColor purest = seen(true, -30);
        return new ColorReport(
                name,
                name,
                new PrincipalDirection(0, OptionalDouble.empty(), 1),
                0,
                65e-6,
                "a plan",
                "a model",
                List.of(0.0),
                colours,
                List.of(new ColorReport.SeenSpectrum(
                        purest.view(), new double[] {380e-9, 590e-9, 780e-9}, new double[] {0, 1, 0}, width)),
                Optional.of(new ColorReport.Purest(purest, width, 20e-9)),
                REACH);
    }

    private static BufferedImage sheet(String... names) {
        Map<String, Object> settings =
                Map.of("exposure", EXPOSURE, "index", "1.5", "method", "full", "options", "tolerance 0.001");
        List<ColorReport> reports = Stream.of(names).map(ColorSheetTest::report).toList();
        return new ColorSheet(reports, settings, CIE).draw();
    }

    /** The longest upright line of ink between two columns: a plot's frame. */
    private static int frame(BufferedImage image, int from, int to) {
        int longest = 0;
        for (int x = from; x < to; x++) {
            int run = 0;
            for (int y = 0; y < image.getHeight(); y++) {
                run = (image.getRGB(x, y) & 0xffffff) == 0x222222 ? run + 1 : 0;
                longest = Math.max(longest, run);
            }
        }
        return longest;
    }

    @Test
    void plotsKeepTheirSizeWhateverTheNames() {
        BufferedImage brief = sheet("a", "b");
        BufferedImage named = sheet(LONG, LONG.replace("03", "04"));
        for (int half = 0; half < 2; half++) {
            int height = frame(named, 640 * half, 640 * (half + 1));
            // Longer names may take one more line of the legend, of 25 pixels, each.
            assertThat(height).isGreaterThan(frame(brief, 640 * half, 640 * (half + 1)) - 55);
            assertThat(height).isGreaterThan(300);
        }
    }

    @Test
    void theTitleSaysTheColourOfTheStripAndTheTables() {
        ColorReport report = report("beetle");
        Map<?, ?> surface = (Map<?, ?>)
                ((List<?>) ColorTables.tree(List.of(report), Map.of()).get("surfaces")).get(0);
        String told = ((Map<?, ?>) surface.get("purest")).get("srgb").toString();

        assertThat(new StripPanel(report, "beetle", 0, 1280).title())
                .endsWith("purest " + told + " at -30\u00b0")
                .startsWith("beetle: ");
        // Dimmer than the hue as bright as a screen shows it.
        assertThat(((Map<?, ?>) surface.get("purest")).get("srgb_brightest")).isNotEqualTo(told);
        // Below 50 pixels of title and marks, the strip's cell around -30 degrees.
        int x = 130 + (50 * (1280 - 160)) / 160;
        assertThat(String.format("#%06x", sheet("beetle").getRGB(x, 80) & 0xffffff))
                .isEqualTo(told);
    }
}
