package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.ExitCode;

@NeedsDisplay
final class BenchmarkCommandTest extends CommandLineFixture {
    /** A short window and a coarse tolerance make small tables. */
    private static final String SMALL = " --size 16 --samples 4 --coherence-length 4um";

    private int run(String words) {
        return sunbeam("benchmark " + words);
    }

    @Test
    void oneMethodStandsBesideTheThesisOnEachSurface() throws IOException {
        assertSuccess(run("--json --patch lamellar --patch lamellar --method table --tolerance 1e-2" + SMALL));

        JsonNode rows = new ObjectMapper().readTree(out.toString()).get("measured");
        assertThat(rows.findValuesAsText("patch")).containsExactly("lamellar", "lamellar", "lamellar-2", "lamellar-2");
        assertThat(rows.findValuesAsText("method"))
                .containsExactly("full, thesis", "table, tolerance 1e-2", "full, thesis", "table, tolerance 1e-2");
        for (int i = 1; i < 4; i += 2) {
            JsonNode table = rows.get(i);
            // Most views of a grating are too dark to measure an error.
            assertThat(table.get("views").intValue()).isBetween(1, 4);
            // The median is promised; the 95th percentile of so few views is nearly the largest error, which is not.
            assertThat(table.get("median_error_of_xyz").doubleValue()).isLessThanOrEqualTo(1e-2);
            assertThat(table.get("bytes").longValue()).isPositive();
        }
    }

    @Test
    void thePageHasEveryMethodAndItsNumbers() throws Exception {
        Path page = folder.resolve("speed.md");
        String words = "--patch lamellar --tolerance 1e-1 --output " + page + SMALL;

        assertSuccess(run(words));

        String[] rows = {"| full, thesis", "| full, tolerance 1e-1", "| table, tolerance 1e-1", "| nmm", "| pq", "| gem"
        };
        assertThat(page).content().contains("\n## lamellar\n", "(speed/lamellar-methods.png)");
        assertThat(page).content().contains(rows);
        assertThat(out.toString()).as("printed, too").contains(rows);
        assertThat(ImageIO.read(folder.resolve("speed/lamellar-methods.png").toFile()))
                .isNotNull();
        List<String> numbers = Files.readAllLines(folder.resolve("speed/benchmark.csv"));
        assertThat(numbers.get(0)).startsWith("patch,method,pixels,");
        assertThat(numbers).hasSize(1 + 6);
        assertThat(numbers.get(6)).as("a method without a scale has no error").contains(",0,NaN,NaN,NaN,");
        assertThat(run(words)).as("an earlier run's page stays").isEqualTo(ExitCode.OUTPUT_EXISTS.code());
    }

    @Test
    void whatIsWrongIsToldBeforeAnythingIsMeasured() {
        assertThat(run("--samples -1")).isEqualTo(2);
        assertThat(run("--patch lamellar --patch no-such-patch")).isEqualTo(4);
        assertThat(run("--patch lamellar --output " + folder.resolve("speed"))).isEqualTo(2);
        assertThat(run("--patch lamellar --output " + folder.resolve(".md"))).isEqualTo(2);
        assertThat(out.toString()).isEmpty();
        assertThat(err.toString().lines()).hasSize(4);
        assertThat(err.toString()).contains("--samples -1", "no-such-patch", "--output", ".md");
        assertThat(folder).isEmptyDirectory();
    }
}
