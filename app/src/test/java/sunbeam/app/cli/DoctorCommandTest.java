package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import sunbeam.app.cli.DoctorCommand.Check;
import sunbeam.app.terminal.Environment;

final class DoctorCommandTest {
    @TempDir
    private Path home;

    private final StringWriter out = new StringWriter();

    private int run(Map<String, String> variables, Supplier<List<Check>> graphics, String... arguments) {
        CommandLine commandLine = new CommandLine(new DoctorCommand(new Environment(variables, home), graphics));
        commandLine.setOut(new PrintWriter(out));
        return commandLine.execute(arguments);
    }

    private List<Check> working() {
        return List.of(Check.ok("GL renderer", "llvmpipe"), Check.ok("GL version", "4.5"));
    }

    private List<Check> none() {
        throw new GraphicsException("no display; install xvfb");
    }

    @Test
    void allIsWellWhereRenderingWorks() {
        assertThat(run(Map.of("DISPLAY", ":99"), this::working)).isZero();
        assertThat(out.toString())
                .contains("Java", "Cores", "Heap", "Free memory", ":99", "GL renderer", "llvmpipe")
                .contains(
                        home.resolve(".cache").resolve("sunbeam") + ", 0 B used of 2.0 GB allowed, ",
                        " free on the disk");
        assertThat(out.toString().lines()).allMatch(line -> line.startsWith("ok    "));
    }

    @Test
    void noGraphicsIsAFailureWithItsRemedy() {
        assertThat(run(Map.of("DISPLAY", ":99"), this::none)).isEqualTo(5);
        assertThat(out.toString()).contains("FAIL  Graphics").contains("no display; install xvfb");
    }

    @Test
    void programsReadTheReportAsJson() throws IOException {
        assertThat(run(Map.of("DISPLAY", ":99"), this::none, "--json")).isEqualTo(5);

        JsonNode report = new ObjectMapper().readTree(out.toString());
        assertThat(report.get("renders").booleanValue()).isFalse();
        List<JsonNode> failed = report.get("checks")
                .valueStream()
                .filter(check -> !check.get("ok").booleanValue())
                .toList();
        assertThat(failed).singleElement().satisfies(check -> {
            assertThat(check.get("name").textValue()).isEqualTo("Graphics");
            assertThat(check.get("remedy").textValue()).isEqualTo("no display; install xvfb");
        });
    }

    @Test
    void whatRenderingDoesNotNeedDoesNotDecide() {
        assertThat(run(Map.of("XDG_CACHE_HOME", "/dev/null", "DISPLAY", ":99"), this::working))
                .isZero();
        assertThat(out.toString()).contains("FAIL  Cache folder").contains("XDG_CACHE_HOME");
    }
}
