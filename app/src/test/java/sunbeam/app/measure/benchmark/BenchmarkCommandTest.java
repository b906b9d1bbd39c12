package sunbeam.app.measure.benchmark;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.Sunbeam;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.Environment;

@NeedsDisplay
final class BenchmarkCommandTest {
    /** A short window and a coarse tolerance make small tables. */
    private static final List<String> SMALL = "--size 16 --frames 1 --samples 4 --coherence-length 4um --tolerance 1e-2"
            .lines()
            .flatMap(line -> Stream.of(line.split(" ")))
            .toList();

    @TempDir
    private Path home;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String words) {
        String[] arguments = Stream.concat(Stream.of(("benchmark " + words).split(" ")), SMALL.stream())
                .toArray(String[]::new);
        return new Sunbeam(new Environment(Map.of(), home), new PrintWriter(out), new PrintWriter(err)).run(arguments);
    }

    private JsonNode json(String words) throws IOException {
        assertThat(run("--json " + words)).as("%s", err).isZero();
        return new ObjectMapper().readTree(out.toString()).get("measured");
    }

    @Test
    void oneMethodStandsBesideTheThesisOnEachSurface() throws IOException {
        JsonNode rows = json("--patch lamellar --patch lamellar --method table");

        assertThat(rows.findValuesAsText("patch")).containsExactly("lamellar", "lamellar", "lamellar-2", "lamellar-2");
        assertThat(rows.findValuesAsText("method"))
                .containsExactly("full, thesis", "table, tolerance 1e-2", "full, thesis", "table, tolerance 1e-2");
        for (int i = 1; i < 4; i += 2) {
            JsonNode table = rows.get(i);
            // Of a grating's views most are too dark to measure an error of.
            assertThat(table.get("views").intValue()).isBetween(1, 4);
            // The promise itself.
            assertThat(table.get("medianErrorOfXyz").doubleValue()).isLessThanOrEqualTo(1e-2);
            assertThat(table.get("percentile95ErrorOfXyz").doubleValue()).isLessThanOrEqualTo(3e-2);
            assertThat(table.get("bytes").longValue()).isPositive();
        }
    }

    @Test
    void thePageHasEveryMethodAndAllGrowthAndItsNumbers() throws IOException {
        Path page = home.resolve("speed.md");

        assertThat(run("--patch lamellar --output " + page)).as("%s", err).isZero();

        String text = Files.readString(page);
        // What is printed is what is written, but for plots.
        assertThat(text.lines().filter(line -> !line.startsWith("![") && !line.contains("benchmark.csv")))
                .containsAll(List.of("## lamellar", "## How cost grows"));
        for (String method :
                List.of("full, thesis", "full, tolerance 1e-2", "table, tolerance 1e-2", "nmm", "pq", "gem")) {
            assertThat(text).contains("\n| " + method);
            assertThat(out.toString()).contains("\n| " + method);
        }
        for (String stem : List.of("lamellar-methods", "pixels", "samples", "relief", "window")) {
            assertThat(text).contains("(speed/" + stem + ".png)");
            assertThat(ImageIO.read(home.resolve("speed/" + stem + ".png").toFile()))
                    .isNotNull();
        }
        List<String> numbers = Files.readAllLines(home.resolve("speed/benchmark.csv"));
        assertThat(numbers.get(0)).startsWith("varied,value,patch,method,pixels,");
        // Six methods; two methods at four sizes of maps, three of patches, four reliefs and four windows.
        assertThat(numbers).hasSize(1 + 6 + 2 * (4 + 3 + 4 + 4));
        // An earlier run's page stays.
        assertThat(run("--patch lamellar --output " + page)).isNotZero();
        assertThat(page).hasContent(text);
    }

    @Test
    void aMethodWithoutAScaleHasNoError() throws IOException {
        JsonNode rows = json("--patch lamellar --method gem");

        assertThat(rows.findValuesAsText("method")).containsExactly("full, thesis", "gem");
        assertThat(rows.get(1).get("views").intValue()).isZero();
        assertThat(rows.get(1).get("medianErrorOfXyz").asText()).isEqualTo("NaN");
    }

    @Test
    void whatIsWrongIsToldBeforeAnythingIsMeasured() {
        assertThat(run("--samples -1")).isEqualTo(2);
        assertThat(run("--frames 0")).isEqualTo(2);
        assertThat(run("--patch lamellar --patch no-such-patch")).isEqualTo(4);
        assertThat(run("--patch lamellar --output " + home.resolve("speed"))).isEqualTo(2);
        assertThat(run("--patch lamellar --output " + home.resolve(".md"))).isEqualTo(2);
        assertThat(out.toString()).isEmpty();
        assertThat(err.toString().lines()).hasSize(5);
        assertThat(err.toString()).contains("--samples -1", "--frames 0", "no-such-patch", "--output", ".md");
        assertThat(home).isEmptyDirectory();
    }
}
