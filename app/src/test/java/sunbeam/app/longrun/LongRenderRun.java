package sunbeam.app.longrun;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.Sunbeam;
import sunbeam.app.terminal.Environment;

/**
 * An animation of many small frames, in one process. Not among the tests: {@code ./sunbeam test -Dtest=LongRenderRun
 * -Dsunbeam.frames=2000}.
 */
final class LongRenderRun {
    @TempDir
    private Path folder;

    @Test
    void memoryResourcesAndFilesDoNotGrowWithFrames() throws Exception {
        int frames = Integer.getInteger("sunbeam.frames", 2000);
        StringWriter err = new StringWriter();
        Sunbeam sunbeam = new Sunbeam(
                new Environment(Map.of("XDG_CACHE_HOME", folder.resolve("cache").toString()), folder),
                new PrintWriter(new StringWriter()),
                new PrintWriter(err));
        Path output = folder.resolve("frames");
        try (Footprint footprint = new Footprint(1000)) {
            String options = "--size 48x36 --method full --tolerance 0.01 --mesh cylinder --texture none";
            int code = sunbeam.run(
                    ("render elaphe --turntable " + frames + " --output " + output + " " + options).split(" "));
            assertThat(code).as(err.toString()).isZero();
            try (Stream<Path> files = Files.list(output)) {
                assertThat(files.filter(file -> file.toString().endsWith(".png")))
                        .hasSize(frames);
            }
            // A collector of garbage may wait, so the heap says little; what leaks with each frame is far more than
            // this.
            assertThat(footprint.growth(Footprint.Look::residentMebibytes))
                    .as("growth of memory / MiB")
                    .isLessThan(100 + 0.05 * frames);
            assertThat(footprint.growth(Footprint.Look::files))
                    .as("growth of open files")
                    .isLessThan(3);
        }
    }

    /** What this process holds, looked at again and again while it works. */
    private static final class Footprint implements AutoCloseable {
        private static final int LOOKS_TO_AVERAGE = 5;

        private final List<Look> looks = new ArrayList<>();
        private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor();

        /**
         * One look.
         *
         * @param residentMebibytes memory of the process, Java's and the driver's
         * @param files open files, sockets and pipes
         */
        record Look(double residentMebibytes, int files) {}

        /** @param milliseconds between two looks */
        Footprint(long milliseconds) {
            Future<?> unused = thread.scheduleAtFixedRate(this::look, 0, milliseconds, TimeUnit.MILLISECONDS);
        }

        private synchronized void look() {
            looks.add(new Look(residentKibibytes() / 1024.0, new File("/proc/self/fd").list().length));
        }

        private static double residentKibibytes() {
            try {
                return Files.readAllLines(Path.of("/proc/self/status")).stream()
                        .filter(line -> line.startsWith("VmRSS:"))
                        .mapToDouble(line -> Double.parseDouble(line.replaceAll("\\D", "")))
                        .findFirst()
                        .orElseThrow();
            } catch (IOException failure) {
                throw new UncheckedIOException(failure);
            }
        }

        /** By how much the mean of the last looks exceeds that of those after the first quarter, when all is warm. */
        synchronized double growth(ToDoubleFunction<Look> quantity) {
            int quarter = looks.size() / 4;
            int count = Math.min(LOOKS_TO_AVERAGE, Math.max(1, quarter));
            return mean(looks.subList(looks.size() - count, looks.size()), quantity)
                    - mean(looks.subList(quarter, quarter + count), quantity);
        }

        private static double mean(List<Look> some, ToDoubleFunction<Look> quantity) {
            return some.stream().mapToDouble(quantity).average().orElseThrow();
        }

        @Override
        public void close() {
            thread.shutdownNow();
        }
    }
}
