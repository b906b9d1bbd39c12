package sunbeam.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;

final class SunbeamTest {
    @TempDir
    private Path home;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return run(Map.of(), arguments);
    }

    private int run(Map<String, String> variables, String... arguments) {
        Environment environment = new Environment(variables, home);
        return new Sunbeam(environment, new PrintWriter(out), new PrintWriter(err)).run(arguments);
    }

    @Test
    void helpReadsAsAManual() {
        assertThat(run("--help")).isZero();
        assertThat(out.toString())
                .containsSubsequence(
                        "Usage: sunbeam",
                        "diffraction",
                        "Options:",
                        "Commands:",
                        "doctor",
                        "Exit codes:",
                        "130",
                        "Files:",
                        "--force",
                        ".cache/sunbeam",
                        "Environment:",
                        "Examples:");
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void helpFitsAnEightyColumnTerminal() {
        run("--help");
        assertThat(out.toString().lines()).allMatch(line -> line.length() <= 80);
    }

    @Test
    void everyCommandHasHelpOfItsOwn() {
        assertThat(run("doctor", "--help")).isZero();
        assertThat(run("help", "doctor")).isZero();
        assertThat(out.toString()).contains("Usage: sunbeam doctor").contains("Exit codes:");
    }

    @Test
    void versionIsTheBuilds() {
        assertThat(run("--version")).isZero();
        assertThat(out.toString()).matches("sunbeam \\d+\\.\\d+\\.\\d+\\R");
    }

    @Test
    void anUnknownOptionIsOneLineThatSaysWhereToReadOn() {
        assertThat(run("doctor", "--sise=3")).isEqualTo(2);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines("sunbeam: unknown option '--sise=3'; see sunbeam doctor --help\n");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void anUnknownCommandIsOneLineWithWhatMayHaveBeenMeant() {
        assertThat(run("docter")).isEqualTo(2);
        assertThat(err.toString())
                .startsWith("sunbeam: unknown command 'docter' (did you mean doctor")
                .endsWith("; see sunbeam --help" + System.lineSeparator())
                .hasLineCount(1);
    }

    @Test
    void anArgumentTooManyIsOneLine() {
        assertThat(run("doctor", "now")).isEqualTo(2);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines("sunbeam: unknown argument 'now'; see sunbeam doctor --help\n");
    }

    @Test
    void noCommandIsAMistakeThatNamesTheCommands() {
        assertThat(run()).isEqualTo(2);
        assertThat(err.toString())
                .startsWith("sunbeam: no command given")
                .contains("doctor")
                .hasLineCount(1);
    }

    @Test
    void stackTracesAppearOnlyWhenAskedFor() {
        run(Map.of("SUNBEAM_DEBUG", "1"), "doctr");
        assertThat(err.toString()).contains("\tat sunbeam.app.Sunbeam.run");
    }
}
