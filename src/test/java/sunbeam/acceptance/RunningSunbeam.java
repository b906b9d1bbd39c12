package sunbeam.acceptance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;

/**
 * A started launcher with its output caught in files. Closing it kills what still runs and removes the files.
 *
 * @param process the launcher's process, which becomes the program's by exec
 */
public record RunningSunbeam(String commandLine, Process process, Path stdout, Path stderr) implements AutoCloseable {
    static RunningSunbeam start(ProcessBuilder builder) throws IOException {
        Path stdout = Files.createTempFile("sunbeam", ".stdout");
        Path stderr = Files.createTempFile("sunbeam", ".stderr");
        builder.redirectInput(Path.of("/dev/null").toFile());
        builder.redirectOutput(stdout.toFile());
        builder.redirectError(stderr.toFile());
        return new RunningSunbeam(String.join(" ", builder.command()), builder.start(), stdout, stderr);
    }

    /** Sends a signal such as {@code INT}, by the shell's kill, since a bare machine has no program of that name. */
    public void signal(String name) throws IOException, InterruptedException {
        assertThat(new ProcessBuilder("sh", "-c", "kill -" + name + " " + process.pid())
                        .start()
                        .waitFor())
                .as("kill -%s", name)
                .isZero();
    }

    /** Waits until standard output has its first whole line, and returns it. */
    public String firstLine() throws Exception {
        await(
                "a line from " + commandLine,
                () -> !process.isAlive() || text(stdout).contains("\n"));
        assertThat(text(stdout)).as("%s: %s", commandLine, text(stderr)).contains("\n");
        return text(stdout).lines().findFirst().orElseThrow();
    }

    /** Waits up to two minutes until a condition holds. */
    public static void await(String what, Callable<Boolean> condition) throws Exception {
        long deadline = System.nanoTime() + Duration.ofMinutes(2).toNanos();
        while (!condition.call()) {
            if (System.nanoTime() > deadline) {
                throw new AssertionError("within two minutes: " + what);
            }
            Thread.sleep(10);
        }
    }

    /**
     * Waits for the end.
     *
     * @throws AssertionError if the time runs out; the program is killed then
     */
    public SunbeamResult end(Duration limit) throws IOException, InterruptedException {
        boolean ended = process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS);
        if (!ended) {
            process.destroyForcibly().waitFor();
        }
        SunbeamResult result = new SunbeamResult(commandLine, process.exitValue(), text(stdout), text(stderr));
        if (!ended) {
            throw new AssertionError("still running after " + limit + ", killed: " + result);
        }
        return result;
    }

    // Unlike Files.readString this accepts invalid bytes: a failure must show all output.
    private static String text(Path file) throws IOException {
        return new String(Files.readAllBytes(file), UTF_8);
    }

    @Override
    public void close() throws IOException {
        process.destroyForcibly();
        Files.deleteIfExists(stdout);
        Files.deleteIfExists(stderr);
    }
}
