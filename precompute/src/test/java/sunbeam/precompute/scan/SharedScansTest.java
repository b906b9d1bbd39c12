package sunbeam.precompute.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Real files of instruments, if shared/ is present, against independent programs. */
class SharedScansTest {
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
