package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import jrtr.GraphicsException;
import jrtr.OwnJvm;
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
                context.close();
            } catch (GraphicsException failure) {
                System.out.println("failed: " + failure.getMessage());
            }
        }
    }

    private OwnJvm run(Map<String, String> environment, boolean headless) throws IOException, InterruptedException {
        return OwnJvm.run(Program.class, folder, environment, "-Djava.awt.headless=" + headless);
    }

    @Test
    void theVirtualMachineEndsByItselfAndSilently() throws IOException, InterruptedException {
        OwnJvm outcome = run(Map.of(), true);

        assertThat(outcome.output()).startsWith("rendered by ");
        assertThat(outcome.errors()).isEmpty();
    }

    @Test
    void withoutADisplayTheMessageSaysSo() throws IOException, InterruptedException {
        OwnJvm outcome = run(Map.of("DISPLAY", ""), true);

        assertThat(outcome.output()).startsWith("failed: no display: DISPLAY is not set. Set DISPLAY");
        assertThat(outcome.output().lines()).hasSize(1);
        assertThat(outcome.errors()).isEmpty();
    }

    @Test
    void aDisplayThatDoesNotAnswerIsNamed() throws IOException, InterruptedException {
        for (boolean headless : new boolean[] {true, false}) {
            OwnJvm outcome = run(Map.of("DISPLAY", ":9999"), headless);

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
            OwnJvm outcome = run(environment, true);

            assertThat(outcome.output()).as("%s", environment).matches("failed: no OpenGL 3.3 .*|rendered by .*");
            assertThat(outcome.errors()).doesNotContain("Exception", "    [0]: ");
        }
    }
}
