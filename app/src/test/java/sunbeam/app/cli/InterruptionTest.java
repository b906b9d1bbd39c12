package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ShutdownHook.CancelledException;

/** Interrupts real processes by the signal that Ctrl-C sends. */
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
                awaitItsEnd(file.path());
                file.fill(stream -> stream.write(new byte[LENGTH]));
            } catch (CancelledException expected) {
                return;
            }
        }
    }

    private static void awaitItsEnd(Path file) throws InterruptedException {
        while (Files.exists(file)) {
            TimeUnit.MILLISECONDS.sleep(1);
        }
    }

    @Test
    void theFileThatIsBeingWrittenGoes() throws Exception {
        interrupt(Waiting.class);
        assertThat(names()).isEmpty();
    }

    @Test
    void aFileThatHasGoneIsNotMadeAgain() throws Exception {
        interrupt(OpeningLate.class);
        assertThat(names()).isEmpty();
    }

    @Test
    void atAnyMomentAllIsTidyAndSilent() throws Exception {
        for (int attempt = 0; attempt < 3; attempt++) {
            interrupt(Rewriting.class);
            assertThat(names()).isEqualTo(Set.of("out.bin"));
            assertThat(Files.size(folder.resolve("out.bin"))).isEqualTo(LENGTH);
        }
    }

    /** A killed process cannot clean up, so the file must be complete at any moment. */
    @Test
    void whatIsKilledLeavesTheOldFileOrTheNewOne() throws Exception {
        for (int attempt = 0; attempt < 3; attempt++) {
            end(Rewriting.class, "KILL", 137);
            assertThat(names()).contains("out.bin");
            assertThat(Files.size(folder.resolve("out.bin"))).isEqualTo(LENGTH);
        }
    }

    private void interrupt(Class<?> program) throws Exception {
        end(program, "INT", 130);
    }

    private void end(Class<?> program, String signal, int exitCode) throws Exception {
        // Restore the signal's default, which nohup and background shells replace.
        Process process = new ProcessBuilder(
                        "env",
                        "--default-signal=INT",
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        System.getProperty("java.class.path"),
                        program.getName(),
                        folder.resolve("out.bin").toString())
                .start();
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

    private Set<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).collect(Collectors.toSet());
        }
    }
}
