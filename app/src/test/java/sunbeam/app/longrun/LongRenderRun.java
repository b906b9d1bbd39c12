package sunbeam.app.longrun;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.terminal.Environment;

/**
 * An animation of many small frames, in one process. Not among the tests: {@code ./sunbeam test -Dtest=LongRenderRun
 * -Dsunbeam.frames=2000}.
 */
final class LongRenderRun {
    @TempDir
    private Path folder;

    /** MiB of this process, Java's and the driver's; number of open files, sockets and pipes. */
    private record Look(double residentMebibytes, int files) {
        static Look now() {
            try {
                String status = Files.readString(Path.of("/proc/self/status"));
                double kibibytes = Double.parseDouble(status.replaceAll("(?s).*VmRSS:\\s*(\\d+).*", "$1"));
                return new Look(kibibytes / 1024, new File("/proc/self/fd").list().length);
            } catch (IOException failure) {
                throw new UncheckedIOException(failure);
            }
        }
    }

    @Test
    void memoryResourcesAndFilesDoNotGrowWithFrames() {
        int frames = Integer.getInteger("sunbeam.frames", 2000);
        StringWriter err = new StringWriter();
        Environment environment = new Environment(Map.of("XDG_CACHE_HOME", folder + "/cache"), folder);
        Sunbeam sunbeam = new Sunbeam(environment, new PrintWriter(new StringWriter()), new PrintWriter(err));
        String command = "render elaphe --size 48x36 --method full --tolerance 0.01 --mesh cylinder --texture none"
                + " --turntable " + frames + " --output " + folder.resolve("frames");
        List<Look> looks = new CopyOnWriteArrayList<>();
        ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor();
        Future<?> unused = thread.scheduleAtFixedRate(() -> looks.add(Look.now()), 0, 1, TimeUnit.SECONDS);
        int code = sunbeam.run(command.split(" "));
        thread.shutdownNow();
        assertThat(code).as(err.toString()).isZero();
        assertThat(folder.resolve("frames").toFile().list()).hasSizeGreaterThanOrEqualTo(frames);
        // After a quarter all is warm.
        Look warm = looks.get(looks.size() / 4);
        Look last = looks.get(looks.size() - 1);
        // A collector of garbage may wait, so the heap says little; what leaks with each frame is far more than this.
        assertThat(last.residentMebibytes - warm.residentMebibytes)
                .as("growth of memory / MiB")
                .isLessThan(100 + 0.05 * frames);
        assertThat(last.files - warm.files).as("growth of open files").isLessThan(3);
    }
}
