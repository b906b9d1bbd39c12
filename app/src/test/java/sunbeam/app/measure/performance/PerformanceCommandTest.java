package sunbeam.app.measure.performance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.GaussianArea;

@EnabledIfEnvironmentVariable(
        named = "DISPLAY",
        matches = ".+",
        disabledReason = "DISPLAY is not set: rendering is not tested. Run ./sunbeam test, or start Xvfb")
final class PerformanceCommandTest {
    private static final GaussianArea SHORT = GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(4e-6));

    /** A short window and coarse tolerances make small tables, one view is aimed at an order, which is bright; the last of the lengths is beyond any budget. */
    private static final Scale TINY = new Scale(
            SHORT,
            List.of(0.1, 0.03),
            16,
            1,
            1,
            0.1,
            List.of(16, 32),
            List.of(16),
            List.of(0.2e-6),
            List.of(4e-6, 200e-6),
            1);

    @TempDir
    private Path folder;

    private void run(Path page) throws Exception {
        PerformanceCommand command = new PerformanceCommand(new Environment(Map.of(), folder), TINY, "lamellar");
        CommandLine line = new CommandLine(command);
        line.setOut(new PrintWriter(new StringWriter()));
        line.setErr(new PrintWriter(new StringWriter()));
        line.parseArgs("--patch", "lamellar", "--output", page.toString());
        command.call();
    }

    @Test
    void onePageShowsAllMethodsAllTolerancesAndAllGrowth() throws Exception {
        Path page = folder.resolve("speed.md");
        run(page);
        String text = Files.readString(page);
        assertThat(text)
                .contains("| full, thesis |", "| gem |", "| nmm |")
                .contains("| table, coherent, tolerance 1e-1 |", "| table, ensemble, tolerance 3e-2 |")
                .containsPattern("\\| look-up of Dhillon et al. 2014, N = \\d+, float32 \\|")
                .contains("lamellar: cost over relief", "lamellar: cost over coherence length")
                .contains("table at 200 has ");
        for (String stem : List.of("lamellar-methods", "pixels", "samples", "relief", "coherence")) {
            assertThat(text).contains("(speed/" + stem + ".png)", "(speed/" + stem + ".csv)");
            assertThat(ImageIO.read(folder.resolve("speed/" + stem + ".png").toFile())
                            .getWidth())
                    .isEqualTo(900);
        }
        List<String> baked = text.lines()
                .filter(line -> line.matches("\\| lamellar \\| (coherent|ensemble), tolerance .*"))
                .toList();
        assertThat(baked).hasSize(4);
        // A finer tolerance has more places.
        assertThat(cell(baked.get(1), 8)).isGreaterThan(cell(baked.get(0), 8));
        // An earlier run's page stays.
        assertThatThrownBy(() -> run(page)).isInstanceOf(OutputException.class);
    }

    private static double cell(String row, int column) {
        return Double.parseDouble(row.split("\\|", -1)[column].strip());
    }

    @Test
    void aPageWithoutItsEndingIsRefusedBeforeAnythingIsMeasured() throws IOException {
        for (String wrong : List.of("speed", ".md")) {
            assertThatThrownBy(() -> run(folder.resolve(wrong)))
                    .isInstanceOf(UsageException.class)
                    .hasMessageContaining("--output")
                    .hasMessageContaining(".md");
        }
        assertThat(folder).isEmptyDirectory();
    }
}
