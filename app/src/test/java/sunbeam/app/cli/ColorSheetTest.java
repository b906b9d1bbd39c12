package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import sunbeam.app.cli.ColorReport.ViewColor;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;

class ColorSheetTest {
    private static final CieTable CIE = CieTable.load();
    private static final double EXPOSURE = 0.3;

    private static ViewColor seen(boolean along, double thetaR, double factor) {
        Direction wr = Direction.ofDegrees(Math.abs(thetaR), thetaR < 0 ? 180 : 0);
        ViewColor.View view = new ViewColor.View(
                along, along ? 0 : 90, 0, 0, thetaR, List.of(new DirectionPair(Direction.ofDegrees(0, 0), wr)));
        // Orange.
        return ViewColor.of(
                view,
                new double[] {0.6 * factor, 0.5 * factor, 0.1 * factor},
                new DisplayTransform(EXPOSURE, Tone.COMPRESS),
                1e-3,
                CIE);
    }

    private static ColorReport report() {
        List<ViewColor> colors = Stream.of(true, false)
                .flatMap(along -> IntStream.rangeClosed(-8, 8).mapToObj(i -> seen(along, 10 * i, 1)))
                .collect(Collectors.toCollection(ArrayList::new));
        ViewColor purest = seen(true, -30, 1);
        HeightMap flat = new HeightMap(2, 2, 1e-6, 1e-6, new double[4]);
        Patch patch = new Patch(
                "beetle", flat, flat, "beetle", List.of(), List.of(), List.of(), List.of(), Patch.Repetition.PERIODIC);
        return new ColorReport(
                patch,
                GratingPeriod.of(patch),
                new Verdict(Verdict.Code.SURE_GRATING, "orange", List.of()),
                true,
                65e-6,
                "a plan",
                colors,
                ColorReport.Spectrum.of(purest.view(), fine(i -> i == 0 ? 1 : 0)),
                Optional.of(purest));
    }

    /** Four samples a nanometer from 380 to 780 nm. */
    private static double[] fine(DoubleUnaryOperator radiance) {
        return IntStream.rangeClosed(0, 1600)
                .mapToDouble(i -> radiance.applyAsDouble(i / 4.0))
                .toArray();
    }

    @Test
    void theTitleSaysTheColorOfTheStripAndTheTables() {
        ColorReport report = report();
        String told = report.purest().orElseThrow().hex();
        Map<String, Object> settings =
                Map.of("exposure", EXPOSURE, "index", "1.5", "method", "full", "options", "tolerance 0.001");
        ColorSheet colors = new ColorSheet(List.of(report), settings, CIE, 1339, Optional.empty());
        BufferedImage sheet = colors.draw().rasterize();
        assertThat(ColorSheet.title(report)).contains("purest (square) " + told + " at -30\u00b0");
        assertThat(report.lines())
                .anyMatch(line -> line.contains("purest color at -30 degrees") && line.contains(told));
        // A pixel of the cell at -30 degrees, beside its mark, in the strip below the title.
        List<Integer> strips = colors.thumbnail();
        int x = strips.get(0) + 50 * strips.get(2) / 160;
        assertThat(String.format("#%06x", sheet.getRGB(x, strips.get(1) + 10) & 0xffffff))
                .isEqualTo(told);
    }

    @Test
    void blackHasNoHueInTheTable() throws IOException {
        ColorReport report = report();
        report.colors().set(0, seen(true, -80, 1e-10));
        ByteArrayOutputStream table = new ByteArrayOutputStream();
        ColorReport.csv(List.of(report)).writeTo(table);
        List<String> lines = table.toString(StandardCharsets.UTF_8).lines().toList();
        List<String> names = List.of(lines.get(0).split(",", -1));
        for (String name : List.of("dominant_nm", "purity")) {
            assertThat(lines.get(1).split(",", -1)[names.indexOf(name)]).isEmpty();
            assertThat(lines.get(2).split(",", -1)[names.indexOf(name)]).isNotEmpty();
        }
    }

    @Test
    void aGrainOfSpeckleIsNotTheWidthOfAColor() {
        DoubleUnaryOperator gaussian = i -> Math.exp(-Math.pow((i - 170) / 40.0, 2) / 2);
        // Grains 5 nm wide; one is three times as bright as its neighbors.
        DoubleUnaryOperator speckled =
                i -> gaussian.applyAsDouble(i) * (i % 10 < 5 ? 2 : 0) * ((int) i / 10 == 17 ? 3 : 1);
        ViewColor.View view = seen(true, 0, 1).view();
        // The quartiles of a normal distribution.
        ColorReport.Spectrum smooth = ColorReport.Spectrum.of(view, fine(gaussian));
        assertThat(smooth.to() - smooth.from()).isCloseTo(2 * 0.6745 * 40e-9, within(0.1e-9));
        // The grain has a fifth of the light, so the quartiles move closer by about a fifth.
        ColorReport.Spectrum grain = ColorReport.Spectrum.of(view, fine(speckled));
        assertThat(grain.to() - grain.from()).isBetween(40e-9, 60e-9);
    }
}
