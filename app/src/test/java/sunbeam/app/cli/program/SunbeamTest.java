package sunbeam.app.cli.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.cli.CommandLineFixture;
import sunbeam.app.cli.program.Sunbeam.Failures;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.MemoryException;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ShutdownHook.CancelledException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Excess;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.setting.ValueKind;

final class SunbeamTest extends CommandLineFixture {
    private int run(Map<String, String> variables, String... arguments) {
        return new Sunbeam(new Environment(variables, folder), new PrintWriter(out), new PrintWriter(err))
                .run(arguments);
    }

    @Test
    void helpIsAlsoACommand() {
        assertThat(sunbeam("help doctor")).isZero();
        assertThat(out.toString()).contains("Usage: sunbeam doctor");
    }

    /** The help fits on two screens of 45 lines and leaves out experts' options. */
    @ParameterizedTest
    @ValueSource(strings = {"render", "color", "brdf-map", "reflectance", "compare"})
    void helpIsShortAndShowsExamples(String command) {
        assertThat(sunbeam(command + " --help")).isZero();
        assertThat(out.toString().lines().count()).isLessThanOrEqualTo(90);
        assertThat(out.toString())
                .containsSubsequence("Surface:", "--patch", "Method:", "--tolerance", "--help-all", "Examples:")
                .doesNotContain("--expansion", "Exit codes:", "${");
    }

    /** The short help has the first three names only: one more illuminant adds no line to it. */
    @Test
    void theShortHelpDoesNotGrowWithTheIlluminants() {
        assertThat(sunbeam("brdf-map --help")).isZero();
        String words = out.toString().replaceAll("\\s+", " ");
        assertThat(words).contains("D65, D50, A or another name").doesNotContain("F11", "LED-B3");
        forgetOutput();
        assertThat(sunbeam("brdf-map --help-all")).isZero();
        assertThat(out.toString().replaceAll("\\s+", " ")).contains(String.join(", ", Illuminant.NAMES));
    }

    @Test
    void versionIsTheBuilds() {
        assertThat(sunbeam("--version")).isZero();
        assertThat(out.toString()).matches("sunbeam \\d+\\.\\d+\\.\\d+\\R");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --theta-i 30 brdf-map | option '--theta-i' has no command before it; give the command first, then
            brdf-map --size 8x8   | option '--size': '8x8' is no whole number, such as 512; see sunbeam brdf-map --help
            export blaze --format npz --output x --theta-max 0,5 | option '--theta-max': '0,5' is no number, such as 0.5; write a decimal point for the comma, "0.5"; see
            color --patch blaze --theta-i 3,5 | --theta-i "3,5" is no angle; give degrees as in 30deg, or radians as in 0.5rad; write a decimal point
            brdf-map --patch nowhere --theta-i 95 | --theta-i 95 deg is out of range; give 0 deg to 89.9 deg
            color --patch nowhere --theta-i 95    | --theta-i 95 deg is out of range; give 0 deg to 89.9 deg
            brdf-map --tolerance 0,01 | --tolerance "0,01" is no number; write a decimal point for the comma, "0.01"
            brdf-map --exposure 1,5 | --exposure '1,5' is neither auto nor a positive number, nor first, nor a picture (.png) to take it from; write a decimal point
            color blaze --output - | cannot write several files to standard output: name a file
            evaluate blaze --output - | cannot write several files to standard output: name a file
            mesh plane --json --output - | --json and --output - both want standard output; name a file, or leave out --json
            brdf-map blaze --json --linear - | --json and --linear - both want standard output
            reflectance --directions - --json --output - | --json and --output - both want standard output
            sample --count 9 --json --output - | --json and --output - both want standard output
            colour               | sunbeam: unknown command 'colour' (did you mean color?); see sunbeam --help
            doctor --sise=3      | sunbeam: unknown option '--sise=3'; see sunbeam doctor --help
            """)
    void whatBeginnersWriteIsOneLineWithTheRemedy(String commandLine, String message) {
        assertComplaint(ExitCode.USAGE, commandLine, message);
    }

    @Test
    void anEmptyNameOfAPatchIsToldByItsOption() {
        assertThat(sunbeam("inspect", "")).isEqualTo(4);
        assertThat(err.toString()).startsWith("sunbeam: --patch is empty; give a built-in patch");
    }

    @Test
    void stackTracesAppearOnlyWhenAskedFor() {
        run(Map.of("SUNBEAM_DEBUG", "1"), "doctr");
        assertThat(err.toString()).contains("\tat sunbeam.app.cli.program.Sunbeam.run");
    }

    @Test
    void aReportThatReachesNobodyIsAFailure() {
        PrintWriter closed = new PrintWriter(Writer.nullWriter());
        closed.close();
        Sunbeam sunbeam = new Sunbeam(new Environment(Map.of(), folder), closed, new PrintWriter(err));
        assertThat(sunbeam.run("--version")).isEqualTo(6);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines(
                        "sunbeam: cannot write to standard output (not everything was written): the program that reads it has"
                                + " ended, or the disk that it goes to is full\n");
    }

    private int report(Throwable failure) {
        return new Failures(new PrintWriter(err), () -> false).report(failure);
    }

    static Stream<Arguments> failures() {
        return Stream.of(
                Arguments.of(new UsageException("what"), 2),
                Arguments.of(new InputException("what"), 4),
                Arguments.of(new GraphicsException("what"), 5),
                Arguments.of(new GraphicsException("what") {}, 5),
                Arguments.of(new GraphicsException.BeyondLimit("what"), 10),
                Arguments.of(new MemoryException("what"), 9),
                Arguments.of(new OutputException("what"), 6),
                Arguments.of(new ExecutionException(new OutputException("what")), 6),
                Arguments.of(new CompletionException(new CompletionException(new InputException("what"))), 4));
    }

    @ParameterizedTest
    @MethodSource("failures")
    void eachKindHasItsExitCodeAndOneLine(Throwable failure, int code) {
        assertThat(report(failure)).isEqualTo(code);
        assertThat(err.toString()).isEqualToNormalizingNewlines("sunbeam: what\n");
    }

    @Test
    void whatIsWrongWithAChoiceDependsOnItsPlace() {
        Setting<String> setting = new Setting<>("mesh", ValueKind.text("MESH"), "Which.");
        assertThat(report(new SettingException(setting, "is odd"))).isEqualTo(2);
        Choices options = Choices.at(OptionOrigin.INSTANCE).with(setting, "cube");
        assertThat(report(options.complaint(setting, "is odd"))).isEqualTo(2);
        assertThat(err.toString()).isEqualToNormalizingNewlines("sunbeam: mesh is odd\nsunbeam: --mesh cube is odd\n");
    }

    @Test
    void aChoiceThatTheMachineCannotServeIsNoWrongCommandLine() {
        Setting<String> setting = new Setting<>("mesh", ValueKind.text("MESH"), "Which.");
        Choices options = Choices.at(OptionOrigin.INSTANCE).with(setting, "cube");
        Excess memory = new Excess("need 3 GB", 4L << 30);

        assertThat(reportLocated(options, new SettingException(setting, "is large").because(memory)))
                .isEqualTo(9);
        assertThat(reportLocated(options, new SettingException(setting, "is long").because(Excess.ofDriver("takes"))))
                .isEqualTo(10);

        assertThat(err.toString())
                .isEqualToNormalizingNewlines("sunbeam: --mesh cube is large; allow more with"
                        + " SUNBEAM_JAVA_OPTIONS=-Xmx4097m\nsunbeam: --mesh cube is long\n");
    }

    /** Reports a failure as a command does, which names the option that its setting has. */
    private int reportLocated(Choices options, SettingException failure) {
        try {
            return options.located(() -> {
                throw failure;
            });
        } catch (SettingException located) {
            return report(located);
        }
    }

    /** The shell's numbers for signals, which no exception has. */
    @Test
    void theHelpListsTheExitCodesOfSignals() {
        assertThat(sunbeam("--help-all")).isZero();
        assertThat(out.toString()).containsPattern("129 +the terminal").containsPattern("143 +terminated");
    }

    @Test
    void anythingElseIsABugAndSaysSo() {
        assertThat(report(new IllegalStateException("oops"))).isEqualTo(1);
        assertThat(err.toString())
                .contains("internal error", "bug", "IllegalStateException", "oops", "--debug")
                .hasLineCount(1);
    }

    @Test
    void outOfMemoryNamesTheOptionThatGivesMore() {
        assertThat(report(new OutOfMemoryError("Java heap space"))).isEqualTo(9);
        assertThat(err.toString())
                .contains("out of memory", "SUNBEAM_JAVA_OPTIONS=-Xmx")
                .doesNotContain("bug")
                .hasLineCount(1);
    }

    @Test
    void anInterruptionIsSilent() {
        assertThat(report(new CancelledException())).isEqualTo(130);
        assertThat(report(new InterruptedException())).isEqualTo(130);
        assertThat(err.toString()).isEmpty();
    }

    private String help(String commandLine) {
        out.getBuffer().setLength(0);
        assertThat(sunbeam(commandLine)).isZero();
        return "\n```text\n" + out.toString().strip() + "\n```\n";
    }

    /** With {@code -Dsunbeam.update=true} the page is written anew. */
    @Test
    void theReferenceOfTheCommandsIsTheirHelp() throws IOException {
        StringBuilder page = new StringBuilder("""
                # Commands

                What `./sunbeam --help` and `./sunbeam COMMAND --help-all` print. Made by
                `./sunbeam test -Dtest=SunbeamTest -Dsunbeam.update=true`.
                """);
        page.append(help("--help"));
        for (String command : ("brdf-map render view inspect color evaluate orders reflectance precompute"
                        + " export sample figures benchmark compare mesh cache doctor")
                .split(" ", -1)) {
            page.append("\n## ").append(command).append('\n').append(help(command + " --help-all"));
        }
        Path reference = Path.of("..", "docs", "reference", "commands.md");
        if (Boolean.getBoolean("sunbeam.update")) {
            Files.createDirectories(reference.getParent());
            Files.writeString(reference, page);
        }
        assertThat(Files.readString(reference)).isEqualTo(page.toString());
    }
}
