package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ShutdownHook.CancelledException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.setting.ValueKind;

final class FailuresTest {
    private final StringWriter err = new StringWriter();

    private int report(Throwable failure, boolean debug) {
        return new Failures(new PrintWriter(err), () -> debug).report(failure);
    }

    static Stream<Arguments> failures() {
        return Stream.of(
                Arguments.of(new UsageException("what"), 2),
                Arguments.of(new InputException("what"), 4),
                Arguments.of(new InputException("what"), 4),
                Arguments.of(new InputException("what"), 4),
                Arguments.of(new GraphicsException("what"), 5),
                Arguments.of(new GraphicsException("what") {}, 5),
                Arguments.of(new OutputException("what"), 6),
                Arguments.of(new ExecutionException(new OutputException("what")), 6),
                Arguments.of(new CompletionException(new CompletionException(new InputException("what"))), 4));
    }

    @ParameterizedTest
    @MethodSource("failures")
    void eachKindHasItsExitCodeAndOneLine(Throwable failure, int code) {
        assertThat(report(failure, false)).isEqualTo(code);
        assertThat(err.toString()).isEqualToNormalizingNewlines("sunbeam: what\n");
    }

    @Test
    void whatIsWrongWithAChoiceDependsOnItsPlace() {
        Setting<String> setting = new Setting<>("mesh", ValueKind.text("MESH"), "Which.");
        assertThat(report(new SettingException(setting, "is odd"), false)).isEqualTo(2);
        Choices options = Choices.at(OptionOrigin.INSTANCE).with(setting, "cube");
        assertThat(report(options.complaint(setting, "is odd"), false)).isEqualTo(2);
        assertThat(err.toString()).isEqualToNormalizingNewlines("sunbeam: mesh is odd\nsunbeam: --mesh cube is odd\n");
    }

    @Test
    void anythingElseIsABugAndSaysSo() {
        assertThat(report(new IllegalStateException("oops"), false)).isEqualTo(1);
        assertThat(err.toString()).contains("internal error", "bug", "IllegalStateException", "oops", "--debug");
        assertThat(err.toString()).hasLineCount(1);
    }

    @Test
    void outOfMemoryNamesTheOptionThatGivesMore() {
        assertThat(report(new OutOfMemoryError("Java heap space"), false)).isEqualTo(1);
        assertThat(err.toString())
                .contains("out of memory", "SUNBEAM_JAVA_OPTIONS=-Xmx")
                .hasLineCount(1);
        assertThat(err.toString()).doesNotContain("bug");
    }

    @Test
    void anInterruptionIsSilent() {
        assertThat(report(new CancelledException(), false)).isEqualTo(130);
        assertThat(report(new InterruptedException(), false)).isEqualTo(130);
        assertThat(err.toString()).isEmpty();
    }
}
