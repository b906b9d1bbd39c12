package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.font.PDFont;
import org.apache.pdfbox.text.PDFTextStripper;
import org.apache.pdfbox.text.TextPosition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.PictureFile;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;

/** Figures for papers: PDF and SVG, the size of their text, single panels and their values. */
final class PaperTest extends CommandLineFixture {
    private static final double POINTS_PER_METER = 72 / 0.0254;
    // PDF has five decimals of a scale, and letters are 8 points high to a thousandth.
    private static final double ROUNDING = 0.01;

    /** A page: its width in points, its words, and the least size of a letter in points; its only fonts are embedded. */
    private record Page(double width, double height, String words, double smallest) {
        static Page read(Path file) throws IOException {
            List<TextPosition> letters = new ArrayList<>();
            PDFTextStripper stripper = new PDFTextStripper() {
                @Override
                protected void writeString(String text, List<TextPosition> positions) throws IOException {
                    letters.addAll(positions);
                    super.writeString(text, positions);
                }
            };
            try (PDDocument document = Loader.loadPDF(file.toFile())) {
                String words = stripper.getText(document);
                PDPage page = document.getPage(0);
                assertThat(letters).extracting(TextPosition::getFont).allMatch(PDFont::isEmbedded);
                assertThat(letters)
                        .extracting(letter -> letter.getFont().getName())
                        .allMatch(name -> name.contains("SunbeamSans"));
                double smallest = letters.stream()
                        .mapToDouble(TextPosition::getYScale)
                        .min()
                        .orElseThrow();
                return new Page(
                        page.getMediaBox().getWidth(), page.getMediaBox().getHeight(), words, smallest);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "inspect sinusoid",
                "color sinusoid --angles -60:60:5",
                "evaluate blaze --wavelengths 500:600:20 --angles -50:-40:0.2",
                "orders blaze --wavelengths 400:700:20",
                "brdf-map blaze --size 256",
                "benchmark --patch blaze --size 16 --samples 2 --method full"
            })
    void printedInAColumnEachTextIsSixPointsOrMore(String command) throws IOException {
        assertSuccess(sunbeam(command + " --output @wide.pdf"));
        Page wide = Page.read(folder.resolve("wide.pdf"));
        assertThat(wide.smallest * 0.085 * POINTS_PER_METER / wide.width).isGreaterThan(6 - ROUNDING);

        assertSuccess(sunbeam(command + " --column-width 85mm --output @column.pdf"));
        Page column = Page.read(folder.resolve("column.pdf"));
        assertThat(column.width).isCloseTo(0.085 * POINTS_PER_METER, within(0.01));
        // The column of a journal; of inspect, which has seven panels, one fits.
        if (!command.startsWith("inspect")) {
            assertThat(column.height).isLessThan(0.225 * POINTS_PER_METER);
        }
        assertThat(column.smallest).isGreaterThan(8 - ROUNDING);
        assertThat(wide.words + column.words).doesNotContain(" um", "nm2", "^");
    }

    @Test
    void theOrdersOfALegendAreCompleteAndSayWhatTheoryTheyAre() throws IOException {
        assertSuccess(sunbeam("orders blaze --wavelengths 400:700:20 --output @o.pdf"));
        String words = Page.read(folder.resolve("o.pdf")).words.replaceAll("\\s+", " ");
        assertThat(words)
                .contains("order \u22123 order \u22122 order \u22121 order 0 order 1 order 2 order 3")
                // Order -1 alone exceeds the mirror's 4 % at 500 nm.
                .contains("scalar theory");
        assertThat(Files.readAllLines(folder.resolve("o.csv")).subList(1, 20))
                .allMatch(line -> line.split(",", -1)[5].matches("-?\\d") && line.split(",", -1)[6].equals("0"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"pdf", "svg", "png"})
    void theSameInputGivesTheSameBytes(String ending) throws IOException {
        assertSuccess(sunbeam("inspect sinusoid --output @one." + ending));
        assertSuccess(sunbeam("inspect sinusoid --output @two." + ending));
        assertThat(folder.resolve("one." + ending)).hasSameBinaryContentAs(folder.resolve("two." + ending));
    }

    @Test
    void anSvgHasAxesAsVectorsAndHeightsAsABitmap() throws IOException {
        assertSuccess(sunbeam("inspect sinusoid --panel heights --column-width 60mm --output @h.svg"));
        String svg = Files.readString(folder.resolve("h.svg"));
        assertThat(svg).contains("width=\"60.000mm\"", "<path", "data:image/png;base64,");
        assertThat(svg.split("<image", -1)).hasSize(2);
    }

    @Test
    void aPngSaysHowLargeItIs() throws IOException {
        assertSuccess(sunbeam("inspect sinusoid --column-width 85mm --output @p.png"));
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try (ImageInputStream stream =
                ImageIO.createImageInputStream(folder.resolve("p.png").toFile())) {
            reader.setInput(stream);
            Element root = (Element) reader.getImageMetadata(0).getAsTree("javax_imageio_png_1.0");
            Element physical = (Element) root.getElementsByTagName("pHYs").item(0);
            double perMeter = Double.parseDouble(physical.getAttribute("pixelsPerUnitXAxis"));
            // Pixels and pixels per meter are whole numbers.
            assertThat(reader.getWidth(0) / perMeter).isCloseTo(0.085, within(0.5 / perMeter));
        } finally {
            reader.dispose();
        }
    }

    @Test
    void densitiesAddUpWhateverTheirBins() throws IOException {
        // 3 periods of a cosine of 100 nm: a variance of 5000 nm^2.
        for (int samples : new int[] {64, 128}) {
            scan(
                    "w.txt",
                    "# Width: 6 um\n# Height: 6 um\n# Value units: nm\n",
                    samples,
                    samples,
                    (column, row) -> 100 * Math.cos(2 * Math.PI * 3 * column / samples));
            assertSuccess(sunbeam("inspect @w.txt --periodic --panel spectrum --force --output @s.pdf"));
            double[][] spectrum = rows("s.csv");
            double step = 1 / 6e-6;
            double sum = Arrays.stream(spectrum).mapToDouble(row -> row[2]).sum();
            // Rounding of a power of 1e-14 m^2.
            assertThat(sum * step * step * 1e18).isCloseTo(5000, within(1e-6));

            assertSuccess(sunbeam("inspect @w.txt --periodic --panel histogram --force --output @h.pdf"));
            double[][] histogram = rows("h.csv");
            double bin = histogram[1][0] - histogram[0][0];
            assertThat(bin * Arrays.stream(histogram).mapToDouble(row -> row[1]).sum())
                    .isCloseTo(1, within(1e-9));
        }
        assertSuccess(sunbeam("inspect @w.txt --periodic --panel profile --output @p.pdf"));
        double[][] profile = rows("p.csv");
        assertThat(profile[1][0] - profile[0][0]).isCloseTo(6e-6 / 128, within(1e-15));
        assertThat(Arrays.stream(profile).mapToDouble(row -> row[1]).max().orElseThrow())
                .isCloseTo(100e-9, within(1e-15));
    }

    @Test
    void aSpectrumIsWrittenWithItsPanel() throws IOException {
        assertSuccess(sunbeam("color sinusoid --angles -60:60:5 --panel spectrum --output @c.svg"));
        assertThat(rows("c.csv")).hasNumberOfRows(401);
        assertThat(Files.readString(folder.resolve("c.csv"))).startsWith("wavelength_nm,radiance_1\n");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            inspect blaze --column-width 0            | --column-width: "0" has no unit
            color blaze --column-width 0mm            | --column-width 0mm: give a length from 40mm to 500mm
            orders blaze --column-width 5m            | --column-width 5m: give a length from 40mm to 500mm
            evaluate blaze --panel profile            | expected one of [RESPONSE]
            inspect blaze --panel phases              | expected one of [HEIGHTS, SPECTRUM, HISTOGRAM, PROFILE]
            inspect blaze --output @x.tiff            | end it with .png or .pdf or .svg
            brdf-map blaze --output @x.eps            | end it with .png or .pdf or .svg
            brdf-map blaze --resume --output @x.pdf   | end --output with .png
            benchmark --output @x.eps                 | give it the ending .md, .pdf, .svg or .png
            inspect blaze --output @missing/x.pdf     | cannot write
            """)
    void mistakesAreOneLine(String line, String words) {
        forgetOutput();
        assertThat(sunbeam(line)).isIn(ExitCode.USAGE.code(), ExitCode.CANNOT_WRITE.code());
        assertThat(err.toString()).contains(words).hasLineCount(1);
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(strings = {"pdf", "svg", "png"})
    void aPictureOfFourThousandPanelsIsRefused(String ending) {
        Drawing panel = new Drawing(1339, 800, graphics -> {});
        Drawing[] panels = new Drawing[4000];
        Arrays.fill(panels, panel);
        Drawing all = Drawing.column(0, panels);
        assertThatThrownBy(() -> PictureFile.of(Path.of("x." + ending), all, Drawing.STANDARD_WIDTH, Map.of()))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("would be 270.8 m high");
    }
}
