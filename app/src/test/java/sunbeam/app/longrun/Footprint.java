package sunbeam.app.longrun;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import jrtr.gl.OpenResources;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;

/** What this process holds, looked at again and again while it works: as a table, a plot, and figures to be asserted. */
public final class Footprint implements AutoCloseable {
    private static final int LOOKS_TO_AVERAGE = 5;

    private final List<Look> looks = new ArrayList<>();
    private final long start = System.nanoTime();
    private final Thread thread;
    private volatile boolean ended;

    /**
     * One look.
     *
     * @param residentMebibytes memory of the process, Java's and the driver's
     * @param heapMebibytes of Java's objects, those included that nobody needs any more
     * @param resources open in OpenGL
     * @param files open files, sockets and pipes
     */
    public record Look(double seconds, double residentMebibytes, double heapMebibytes, int resources, int files) {}

    /** @param milliseconds between two looks */
    public Footprint(long milliseconds) {
        thread = new Thread(() -> watch(milliseconds), "footprint");
        thread.setDaemon(true);
        thread.start();
    }

    private void watch(long milliseconds) {
        try {
            while (!ended) {
                look();
                Thread.sleep(milliseconds);
            }
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized void look() {
        Runtime java = Runtime.getRuntime();
        looks.add(new Look(
                (System.nanoTime() - start) * 1e-9,
                residentKibibytes() / 1024.0,
                (java.totalMemory() - java.freeMemory()) / 1048576.0,
                OpenResources.count(),
                openFiles()));
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

    private static int openFiles() {
        int count = 0;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(Path.of("/proc/self/fd"))) {
            for (Path ignored : files) {
                count++;
            }
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return count;
    }

    /** All looks so far. */
    public synchronized List<Look> looks() {
        return List.copyOf(looks);
    }

    /** By how much the mean of the last looks exceeds that of those after the first quarter, when all is warm. */
    public double growth(ToDoubleFunction<Look> quantity) {
        List<Look> all = looks();
        int quarter = all.size() / 4;
        int count = Math.min(LOOKS_TO_AVERAGE, Math.max(1, quarter));
        return mean(all.subList(all.size() - count, all.size()), quantity)
                - mean(all.subList(quarter, quarter + count), quantity);
    }

    private static double mean(List<Look> some, ToDoubleFunction<Look> quantity) {
        return some.stream().mapToDouble(quantity).average().orElseThrow();
    }

    /** Writes {@code NAME.csv} and {@code NAME.png}. */
    public void write(Path folder, String name) throws IOException {
        Files.createDirectories(folder);
        List<Look> all = looks();
        AtomicFile.write(folder.resolve(name + ".csv"), Overwrite.REPLACE, stream -> {
            try (CsvWriter csv = new CsvWriter(
                    stream, List.of("seconds", "resident_mebibytes", "heap_mebibytes", "gl_resources", "open_files"))) {
                for (Look look : all) {
                    csv.row(
                            look.seconds(),
                            look.residentMebibytes(),
                            look.heapMebibytes(),
                            look.resources(),
                            look.files());
                }
            }
        });
        double[] minutes = column(all, look -> look.seconds() / 60);
        new Plot(new Frame(name, Axis.linear("time / min"), Axis.logarithmic("MiB, or number"), 820, 480))
                .line("resident / MiB", minutes, column(all, Look::residentMebibytes))
                .line("Java's heap / MiB", minutes, column(all, Look::heapMebibytes))
                .line("GL resources + 1", minutes, column(all, look -> look.resources() + 1.0))
                .line("open files", minutes, column(all, Look::files))
                .write(folder.resolve(name + ".png"), Overwrite.REPLACE, Map.of("Title", name));
    }

    private static double[] column(List<Look> looks, ToDoubleFunction<Look> quantity) {
        double[] values = looks.stream().mapToDouble(quantity).toArray();
        return Arrays.copyOf(values, values.length);
    }

    @Override
    public void close() {
        ended = true;
        thread.interrupt();
    }
}
