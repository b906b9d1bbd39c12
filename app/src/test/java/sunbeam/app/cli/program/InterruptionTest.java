package sunbeam.app.cli.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.Main;
import sunbeam.app.cli.program.Sunbeam.Failures;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.ShutdownHook.CancelledException;

/** Processes of their own, also interrupted by the signal that Ctrl-C sends. */
final class InterruptionTest {
    private static final int LENGTH = 100_000;

    @TempDir
    private Path folder;

    /** Process that rewrites one file until it is interrupted. */
    static final class Rewriting {
        private Rewriting() {}

        public static void main(String[] arguments) {
            Path target = Path.of(arguments[0]);
            try {
                for (int round = 0; ; round++) {
                    AtomicFile.write(target, Overwrite.REPLACE, stream -> stream.write(new byte[LENGTH]));
                    if (round == 0) {
                        System.out.println("ready");
                    }
                }
            } catch (Throwable failure) {
                System.exit(new Failures(new PrintWriter(System.err, true, StandardCharsets.UTF_8), () -> false)
                        .report(failure));
            }
        }
    }

    /** Process that is interrupted while it writes a file. */
    static final class Waiting {
        private Waiting() {}

        public static void main(String[] arguments) {
            AtomicFile.write(Path.of(arguments[0]), Overwrite.REFUSE, stream -> {
                stream.write(new byte[LENGTH]);
                stream.flush();
                System.out.println("ready");
                try {
                    TimeUnit.MINUTES.sleep(5);
                } catch (InterruptedException unexpected) {
                    throw new IOException(unexpected);
                }
            });
        }
    }

    /** Process that is interrupted between creating a file and opening it. */
    static final class OpeningLate {
        private OpeningLate() {}

        public static void main(String[] arguments) throws InterruptedException {
            try (AtomicFile file = AtomicFile.create(Path.of(arguments[0]), Overwrite.REFUSE)) {
                System.out.println("ready");
                while (Files.exists(file.path())) {
                    TimeUnit.MILLISECONDS.sleep(1);
                }
                file.fill(stream -> stream.write(new byte[LENGTH]));
            } catch (CancelledException expected) {
                return;
            }
        }
    }

    @ParameterizedTest
    @ValueSource(classes = {Waiting.class, OpeningLate.class})
    void theFileThatIsBeingWrittenGoesAndIsNotMadeAgain(Class<?> program) throws Exception {
        end(program, "INT", 130);
        assertThat(folder.toFile().list()).isEmpty();
    }

    /** A killed process cannot clean up: each of three may leave a temporary file beside the whole one. */
    @ParameterizedTest
    @CsvSource({"INT, 130, 1", "KILL, 137, 4"})
    void atAnyMomentTheFileIsWhole(String signal, int exitCode, int mostFiles) throws Exception {
        for (int attempt = 0; attempt < 3; attempt++) {
            end(Rewriting.class, signal, exitCode);
            assertThat(Files.size(folder.resolve("out.bin"))).isEqualTo(LENGTH);
            assertThat(folder.toFile().list()).hasSizeLessThanOrEqualTo(mostFiles);
        }
    }

    private void end(Class<?> program, String signal, int exitCode) throws Exception {
        Process process = java(program, folder.resolve("out.bin").toString()).start();
        try (InputStream out = process.getInputStream();
                InputStream err = process.getErrorStream()) {
            assertThat(new String(out.readNBytes(5), StandardCharsets.US_ASCII)).isEqualTo("ready");
            new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid()))
                    .start()
                    .waitFor();
            assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
            assertThat(process.exitValue()).isEqualTo(exitCode);
            assertThat(new String(err.readAllBytes(), StandardCharsets.UTF_8)).isEmpty();
        } finally {
            process.destroyForcibly();
        }
    }

    /** Java opens the display only once. */
    @ParameterizedTest
    @ValueSource(strings = {":4711", "nonsense"})
    @EnabledOnOs(OS.LINUX)
    void aScreenWithoutAServerIsOneLine(String display) throws Exception {
        ProcessBuilder builder = java(Main.class, "view", "elaphe");
        builder.environment().put("DISPLAY", display);
        Process process = builder.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        assertThat(said.strip().lines())
                .singleElement()
                .asString()
                .contains("cannot open the screen", "'" + display + "'", "set DISPLAY");
        assertThat(process.exitValue()).isEqualTo(ExitCode.NO_GRAPHICS.code());
    }

    private static ProcessBuilder java(Class<?> program, String... arguments) {
        // Restore the signal's default, which nohup and background shells replace.
        List<String> command = new ArrayList<>(List.of("env", "--default-signal=INT"));
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of("-XX:TieredStopAtLevel=1", "-Djava.awt.headless=false", "-cp"));
        command.addAll(List.of(System.getProperty("java.class.path"), program.getName()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }
}
