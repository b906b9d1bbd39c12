package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that need their own virtual machine: its end, its standard streams, its display. */
@NeedsDisplay
class OwnJvmTest {
    @TempDir
    private Path folder;

    /** Prints the renderer, or the exception's message. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) {
            try {
                RenderContext context = RenderContext.offscreen();
                System.out.println("rendered by " + context.info().renderer());
                if (!List.of(arguments).contains("leave-open")) {
                    context.close();
                }
            } catch (GraphicsException failure) {
                System.out.println("failed: " + failure.getMessage());
            }
        }
    }

    private record Outcome(String output, String errors) {}

    private Outcome run(Map<String, String> environment, boolean headless, String... arguments)
            throws IOException, InterruptedException {
        Path output = folder.resolve("output");
        Path errors = folder.resolve("errors");
        ProcessBuilder builder = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=" + headless,
                "-cp",
                System.getProperty("java.class.path"),
                Program.class.getName());
        builder.command().addAll(List.of(arguments));
        environment.forEach((name, value) -> {
            if (value.isEmpty()) {
                builder.environment().remove(name);
            } else {
                builder.environment().put(name, value);
            }
        });
        Process process = builder.redirectOutput(output.toFile())
                .redirectError(errors.toFile())
                .start();
        // A start takes about a second; a thread that keeps the machine alive would do so for ever.
        boolean ended = process.waitFor(30, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).as("the virtual machine ends by itself").isTrue();
        return new Outcome(
                Files.readString(output, StandardCharsets.UTF_8).strip(),
                Files.readString(errors, StandardCharsets.UTF_8).strip());
    }

    @Test
    void theVirtualMachineEndsByItselfAndSilently() throws IOException, InterruptedException {
        Outcome outcome = run(Map.of(), true);

        assertThat(outcome.output()).startsWith("rendered by ");
        assertThat(outcome.errors()).isEmpty();
    }

    @Test
    void withoutADisplayTheMessageSaysSo() throws IOException, InterruptedException {
        Outcome outcome = run(Map.of("DISPLAY", ""), true);

        assertThat(outcome.output()).startsWith("failed: no display: DISPLAY is not set. Set DISPLAY");
        assertThat(outcome.output().lines()).hasSize(1);
        assertThat(outcome.errors()).isEmpty();
    }

    @Test
    void aDisplayThatDoesNotAnswerIsNamed() throws IOException, InterruptedException {
        for (boolean headless : new boolean[] {true, false}) {
            Outcome outcome = run(Map.of("DISPLAY", ":9999"), headless);

            assertThat(outcome.output()).startsWith("failed: no display: DISPLAY=:9999 does not answer");
            assertThat(outcome.errors()).isEmpty();
        }
    }

    /** The variables are Mesa's; another driver ignores them and renders, which is right too. */
    @Test
    void aDriverThatIsTooOldOrMissingIsAFailureOnOneLineWithoutStackTraces() throws IOException, InterruptedException {
        Map<String, String> tooOld = Map.of("MESA_GL_VERSION_OVERRIDE", "2.1", "MESA_GLES_VERSION_OVERRIDE", "2.0");
        Map<String, String> missing =
                Map.of("LIBGL_DRIVERS_PATH", folder.resolve("nothing").toString());
        for (Map<String, String> environment : List.of(tooOld, missing)) {
            Outcome outcome = run(environment, true);

            assertThat(outcome.output()).as("%s", environment).matches("failed: no OpenGL 3.3 .*|rendered by .*");
            assertThat(outcome.errors()).doesNotContain("Exception", "    [0]: ");
        }
    }
}
