package sunbeam.precompute.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** TIFF files of one surface, written by Python's tifffile; and real files of instruments, if shared/ is present. */
class ForeignFilesTest {
    private static final int COLUMNS = 20;
    private static final int ROWS = 12;

    @TempDir
    Path folder;

    private static Path file(String name) throws URISyntaxException {
        return Path.of(
                ForeignFilesTest.class.getResource("tiff/" + name + ".tif").toURI());
    }

    private static void assertSurface(ScanChannel channel, double factor) throws IOException {
        double[] samples = channel.samples().read();
        assertThat(channel.columns()).isEqualTo(COLUMNS);
        assertThat(channel.rows()).isEqualTo(ROWS);
        for (int i = 0; i < samples.length; i++) {
            int sixtyThirds = (7 * (i / COLUMNS) + 11 * (i % COLUMNS)) % 64;
            // Signed integers shift heights. Half of a step of 8 bits on both sides.
            assertThat(samples[i] - samples[0])
                    .as("sample %d", i)
                    .isCloseTo(factor * sixtyThirds / 63, within(1 / 255.0));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "unsigned8-lzw-predictor2", "unsigned16-lzw-predictor2-big-endian",
                "unsigned16-zip-predictor2-tiles", "unsigned32-zip-predictor2-big-endian",
                "unsigned32", "signed8-packbits",
                "signed16-zip-predictor2-big-endian", "signed32-lzw-predictor2",
                "float16-big-endian", "float16-zip-predictor3",
                "float32-lzw-predictor3-big-endian", "float32-zip-predictor3-tiles",
                "float64-zip-predictor3-big-endian", "bigtiff-float32-zip-predictor3",
                "bigtiff-unsigned16-big-endian", "white-is-zero-unsigned8",
                "white-is-zero-unsigned16-lzw-predictor2", "rgb-unsigned16-planar-lzw-predictor2"
            })
    void readsEveryWayOfWritingASurface(String name) throws Exception {
        try (ScanBytes bytes = ScanBytes.open(file(name))) {
            ChannelList channels = TestScans.channels(bytes);

            assertThat(channels.labels().get(channels.heights().orElseThrow())).isEqualTo("grey");
            assertSurface(channels.channels().get(0), 1);
        }
    }

    /** 12.8 pixels per micrometer along x, 6.4 along y. */
    @ParameterizedTest
    @ValueSource(strings = {"imagej-micron", "imagej-escaped-micrometers"})
    void takesTheSizeFromImageJsResolutionAndUnit(String name) throws Exception {
        try (ScanBytes bytes = ScanBytes.open(file(name))) {
            ScanChannel channel = TestScans.channels(bytes).channels().get(0);

            assertSurface(channel, 1);
            // Resolutions are fractions of 32-bit integers.
            assertThat(channel.extent().width().orElseThrow()).isCloseTo(COLUMNS / 12.8e6, within(1e-14));
            assertThat(channel.extent().height().orElseThrow()).isCloseTo(ROWS / 6.4e6, within(1e-14));
        }
    }

    /** Pixels of 1/12.8 um by 156.25 nm in OME's XML and ImageJ's units; of 2 by 4 without unit in GeoTIFF. */
    @ParameterizedTest
    @CsvSource({"imagej-two-units, true", "ome, true", "gdal-missing, false"})
    void takesTheShapeOfPixelsAsItIsDeclared(String name, boolean sized) throws Exception {
        try (ScanBytes bytes = ScanBytes.open(file(name))) {
            Extent extent = TestScans.channels(bytes).channels().get(0).extent();

            assertThat(extent.width().isPresent()).isEqualTo(sized);
            assertThat(extent.aspect()).isEqualTo(sized ? 1 : 2);
            // Resolutions are fractions of 32-bit integers.
            extent.width().ifPresent(width -> assertThat(width).isCloseTo(COLUMNS / 12.8e6, within(1e-14)));
            extent.height().ifPresent(height -> assertThat(height).isCloseTo(ROWS * 156.25e-9, within(1e-14)));
        }
    }

    @Test
    void samplesThatGdalDeclaresAsMissingAreMissing() throws Exception {
        try (ScanBytes bytes = ScanBytes.open(file("gdal-missing"))) {
            double[] samples =
                    TestScans.channels(bytes).channels().get(0).samples().read();

            assertThat(IntStream.range(0, samples.length).filter(i -> Double.isNaN(samples[i])))
                    .containsExactly(3 * COLUMNS + 5, 11 * COLUMNS + 19);
        }
    }

    /** 0.002 nm a step above -100 nm; 65535 steps are 131.07 nm. */
    @Test
    void imageJsCalibrationGivesHeights() throws Exception {
        try (ScanBytes bytes = ScanBytes.open(file("imagej-calibrated"))) {
            ScanChannel channel = TestScans.channels(bytes).channels().get(0);

            assertThat(channel.unit()).isEqualTo("nm");
            assertThat(channel.samples().read()[1]).isCloseTo(0.002 * 11_000 - 100, within(1e-9));
            assertThat(channel.span()).isCloseTo(131.07, within(1e-9));
        }
        byte[] inches = Files.readAllBytes(file("imagej-micron"));
        String inch = new String(inches, StandardCharsets.ISO_8859_1).replace("unit=micron", "unit=inch  ");
        Path wide = Files.writeString(folder.resolve("inch.tif"), inch, StandardCharsets.ISO_8859_1);
        try (ScanBytes bytes = ScanBytes.open(wide)) {
            // Resolutions are fractions of 32-bit integers.
            assertThat(TestScans.channels(bytes)
                            .channels()
                            .get(0)
                            .extent()
                            .width()
                            .orElseThrow())
                    .isCloseTo(COLUMNS / 12.8 * 25.4e-3, within(1e-9));
        }
        byte[] curved = Files.readAllBytes(file("imagej-calibrated"));
        String text = new String(curved, StandardCharsets.ISO_8859_1).replace("cf=0", "cf=3");
        Path file = Files.writeString(folder.resolve("curved.tif"), text, StandardCharsets.ISO_8859_1);
        try (ScanBytes bytes = ScanBytes.open(file)) {
            assertThatThrownBy(() -> TestScans.channels(bytes)).hasMessageContaining("calibration function 3");
        }
    }

    /** A thumbnail, the surface, its double, a JPEG. */
    @Test
    void readsTheFirstWholePageAndNamesTheOthers() throws Exception {
        try (ScanBytes bytes = ScanBytes.open(file("pages"))) {
            ChannelList channels = TestScans.channels(bytes);

            assertThat(channels.labels()).containsExactly("page 2 grey", "page 3 grey");
            assertThat(channels.heights()).contains(0);
            assertThat(channels.candidates()).isEqualTo(2);
            assertThat(channels.find("grey")).contains(0);
            assertSurface(channels.channels().get(0), 1);
            assertSurface(channels.channels().get(1), 2);
        }
    }

    @Test
    void tagsThatShareTheirBytesAreNotReadIntoMemory() throws IOException {
        int tags = 3000;
        int size = 1 << 16;
        // Each tag claims the whole file: 200 MB from 64 KB.
        ByteBuffer tiff = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
        tiff.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(8).putShort((short) tags);
        for (int tag = 0; tag < tags; tag++) {
            tiff.putShort((short) (40_000 + tag))
                    .putShort((short) 7)
                    .putInt(size)
                    .putInt(0);
        }
        Path file = Files.write(folder.resolve("bomb.tif"), tiff.array());
        try (ScanBytes bytes = ScanBytes.open(file)) {
            assertThatThrownBy(() -> TiffPage.read(bytes))
                    .isInstanceOf(ScanException.class)
                    .hasMessageContaining("tags larger than the file");
        }
    }

    private static final Path SCANS = Path.of("..", "..", "shared", "scans");

    private static JsonNode expected(String name) throws IOException {
        Path file = SCANS.resolve("expected.json");
        assumeTrue(Files.exists(file), () -> "the instruments' files are not there: " + file);
        return new ObjectMapper().readTree(file.toFile()).get(name);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "di-1.di", "di-3.di", "spot_1-1000nm.ibw", "nid-1.nid",
                "example_ps.tiff", "sample_0.jpk", "stp-1.stp", "top-1.top",
                "x3p-2.x3p", "sdf-1.sdf", "mi-1.mi", "sur-2.sur",
                "test.gwy", "gwyddion-export-english.txt", "gwyddion-export-german.txt", "matrix-3.txt",
                "matrix-6.txt", "txt_example.txt", "xyz-1.txt", "xyz-2.txt"
            })
    void agreesWithOtherPrograms(String name) throws IOException {
        JsonNode expected = expected(name);
        try (ScanBytes bytes = ScanBytes.open(SCANS.resolve(name))) {
            ChannelList channels = TestScans.channels(bytes);
            assertThat(channels.count()).isEqualTo(expected.get("channels").size());
            Map<String, Integer> seen = new HashMap<>();
            for (JsonNode heights : expected.get("heights")) {
                String channel = heights.get("channel").asText();
                int before = seen.merge(channel, 1, Integer::sum) - 1;
                // Points have an upward y here; that program counts rows with y.
                assertSameChannel(called(channels, channel).get(before), heights, name.startsWith("xyz"));
            }
        }
    }

    /** By name, in the file's order; programs invent names where a file has none. */
    private static List<ScanChannel> called(ChannelList channels, String name) {
        return IntStream.range(0, channels.count())
                .filter(i -> channels.count() == 1
                        || channels.labels().get(i).equals(name)
                        || channels.channels().get(i).name().equals(name))
                .mapToObj(channels.channels()::get)
                .toList();
    }

    private static void assertSameChannel(ScanChannel channel, JsonNode expected, boolean upwards) throws IOException {
        assertThat(channel.columns()).isEqualTo(expected.get("columns").asInt());
        assertThat(channel.rows()).isEqualTo(expected.get("rows").asInt());
        double side = expected.get("unit_xy").asText().equals("mm") ? 1e-3 : 1;
        Map.of("width", channel.extent().width(), "height", channel.extent().height())
                .forEach((name, length) -> length.ifPresent(meters -> assertThat(meters)
                        .as(name)
                        .isCloseTo(side * expected.get(name).asDouble(), within(1e-6 * meters))));
        double unit = expected.get("unit_z").asText().equals("mm") ? 1e-3 : 1;
        double meters = channel.metersPerUnit().orElse(1.0);
        double[] samples =
                Arrays.stream(channel.samples().read()).map(s -> meters * s).toArray();
        DoubleSummaryStatistics statistics =
                Arrays.stream(samples).filter(Double::isFinite).summaryStatistics();
        double tolerance = 1e-6 * (statistics.getMax() - statistics.getMin());
        Map.of("min", statistics.getMin(), "max", statistics.getMax(), "mean", statistics.getAverage())
                .forEach((name, value) -> assertThat(value)
                        .as(name)
                        .isCloseTo(unit * expected.get(name).asDouble(), within(tolerance)));
        for (JsonNode point : expected.get("points")) {
            int line = point.get(0).asInt();
            int row = upwards ? channel.rows() - 1 - line : line;
            double sample = samples[row * channel.columns() + point.get(1).asInt()];
            if (point.get(2).isNull()) {
                assertThat(sample).as("%s", point).isNaN();
            } else {
                assertThat(sample).as("%s", point).isCloseTo(unit * point.get(2).asDouble(), within(tolerance));
            }
        }
    }
}
