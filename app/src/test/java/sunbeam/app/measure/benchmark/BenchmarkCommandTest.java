package sunbeam.app.measure.benchmark;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.Sunbeam;
import sunbeam.app.terminal.Environment;

@EnabledIfEnvironmentVariable(
        named = "DISPLAY",
        matches = ".+",
        disabledReason = "DISPLAY is not set: rendering is not tested. Run ./sunbeam test, or start Xvfb")
final class BenchmarkCommandTest {
    private static final Pattern LINE = Pattern.compile(
            "  (full, thesis, coherent|table, coherent|table, ensemble) +([0-9.]+) s"
                    + " +[0-9.]+ s +[0-9.]+ s +[0-9.]+ [nu]s +([0-9.]+) +([0-9.]+) +([0-9.e+-]+) +([0-9.e+-]+) +(\\d+)");

    @TempDir
    private Path home;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return new Sunbeam(new Environment(Map.of(), home), new PrintWriter(out), new PrintWriter(err)).run(arguments);
    }

    private List<Matcher> lines() {
        return out.toString()
                .lines()
                .map(LINE::matcher)
                .filter(Matcher::matches)
                .toList();
    }

    @Test
    void eachLineHasTimesAndTheErrorOfThatVeryTableForSurfacesAndAverages() {
        // A short window and a coarse tolerance make small tables.
        assertThat(run(
                        "benchmark",
                        "--patch",
                        "lamellar",
                        "--with",
                        "lamellar",
                        "--method",
                        "table",
                        "--size",
                        "16",
                        "--frames",
                        "1",
                        "--samples",
                        "2",
                        "--coherence-length",
                        "4um",
                        "--tolerance",
                        "1e-2"))
                .as("%s", err)
                .isZero();
        assertThat(lines().stream().map(line -> line.group(1)))
                .containsExactly(
                        "full, thesis, coherent",
                        "table, coherent",
                        "table, ensemble",
                        "full, thesis, coherent",
                        "table, coherent",
                        "table, ensemble");
        for (Matcher line : lines()) {
            boolean thesis = line.group(1).startsWith("full");
            double drawing = Double.parseDouble(line.group(3));
            double firstFrame = Double.parseDouble(line.group(4));
            // Of a grating's views most are too dark to measure an error of.
            assertThat(Integer.parseInt(line.group(7))).isBetween(1, 2);
            if (thesis) {
                assertThat(List.of(drawing, firstFrame)).containsOnly(1.0);
            } else {
                assertThat(Double.parseDouble(line.group(5))).isLessThanOrEqualTo(1e-2);
                // Of two errors the 95th percentile is nearly the largest.
                assertThat(Double.parseDouble(line.group(6))).isLessThanOrEqualTo(3e-2);
                assertThat(Double.parseDouble(line.group(2)))
                        .as("baking takes time")
                        .isPositive();
            }
        }
    }

    @Test
    void programsReadTheReportAsJson() throws IOException {
        assertThat(run(
                        "benchmark",
                        "--json",
                        "--patch",
                        "lamellar",
                        "--method",
                        "gem",
                        "--size",
                        "16",
                        "--frames",
                        "1",
                        "--samples",
                        "0"))
                .as("%s", err)
                .isZero();
        JsonNode surface = new ObjectMapper().readTree(out.toString()).at("/surfaces/0");
        assertThat(surface.get("patch").textValue()).isEqualTo("lamellar");
        JsonNode methods = surface.get("methods");
        assertThat(methods).hasSize(2);
        assertThat(methods.at("/0/timesFasterDrawing").doubleValue()).isEqualTo(1);
        assertThat(methods.at("/1/method").textValue()).isEqualTo("gem");
        assertThat(methods.at("/1/timesFasterDrawing").doubleValue())
                .isEqualTo(methods.at("/0/frameSeconds").doubleValue()
                        / methods.at("/1/frameSeconds").doubleValue());
        assertThat(methods.at("/1/medianErrorOfXyz").isMissingNode())
                .as("not measured")
                .isTrue();
    }

    @Test
    void whatIsOutOfRangeIsToldBeforeAnythingIsMeasured() {
        assertThat(run("benchmark", "--samples", "-1")).isEqualTo(2);
        assertThat(run("benchmark", "--size", "8")).isEqualTo(2);
        assertThat(run("benchmark", "--with", "no-such-patch")).isEqualTo(4);
        assertThat(out.toString()).isEmpty();
        assertThat(err.toString().lines()).hasSize(3);
        assertThat(err.toString()).contains("--samples -1", "--size 8", "no-such-patch");
    }
}
