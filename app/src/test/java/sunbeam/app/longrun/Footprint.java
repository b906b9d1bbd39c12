package sunbeam.app.longrun;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** What this process holds, looked at again and again while it works. */
public final class Footprint implements AutoCloseable {
    private static final int LOOKS_TO_AVERAGE = 5;

    private final List<Look> looks = new ArrayList<>();
    private final Thread thread;
    private volatile boolean ended;

    /**
     * One look.
     *
     * @param residentMebibytes memory of the process, Java's and the driver's
     * @param files open files, sockets and pipes
     */
    public record Look(double residentMebibytes, int files) {}

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
    public synchronized double growth(ToDoubleFunction<Look> quantity) {
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
        ended = true;
        thread.interrupt();
    }
}
