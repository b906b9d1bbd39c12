package sunbeam.app.fuzz;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import sunbeam.app.failure.Failure;

/**
 * One input to one reader. An input passes when it is read, or refused by an exception that the program words for its user;
 * what the program would call a bug of its own, and more than 5 s of a processor, is a finding. Memory is the machine's that
 * runs it: 512 MB.
 */
public final class FuzzTarget {
    /** The reader's label. */
    static final String READER = "sunbeam.fuzz.reader";

    static final Duration MOST_TIME = Duration.ofSeconds(5);
    static final String HEAP = "-Xmx512m";

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final FuzzedReader reader;
    private final Path file;
    private long tried;
    private long read;

    FuzzTarget(FuzzedReader reader, Path folder) {
        this.reader = reader;
        this.file = folder.resolve(reader.fileName());
    }

    /** What Jazzer calls: the reader is the one of the system property. */
    public static void fuzzerTestOneInput(byte[] input) throws IOException {
        Chosen.TARGET.check(input);
    }

    /** What Jazzer calls at the end. */
    public static void fuzzerTearDown() {
        Chosen.TARGET.report();
    }

    private static final class Chosen {
        private static final FuzzTarget TARGET = target();

        private static FuzzTarget target() {
            try {
                return new FuzzTarget(
                        FuzzedReader.of(System.getProperty(READER)), Files.createTempDirectory("sunbeam-fuzz"));
            } catch (IOException failure) {
                throw new IllegalStateException(failure);
            }
        }
    }

    /**
     * Tries one input.
     *
     * @throws AssertionError for a finding
     */
    void check(byte[] input) throws IOException {
        Files.write(file, input);
        tried++;
        long start = THREADS.getCurrentThreadCpuTime();
        try {
            reader.read(file);
            read++;
        } catch (RuntimeException | IOException refused) {
            Failure failure = Failure.of(refused);
            if (failure.isBug()) {
                throw new AssertionError(reader.label() + ": " + refused, refused);
            }
        }
        Duration taken = Duration.ofNanos(THREADS.getCurrentThreadCpuTime() - start);
        if (taken.compareTo(MOST_TIME) > 0) {
            throw new AssertionError(reader.label() + " took " + taken + " of a processor");
        }
    }

    private void report() {
        System.err.printf(
                Locale.ROOT,
                "%s: %d inputs, of which %d (%.0f %%) were read%n",
                reader.label(),
                tried,
                read,
                100.0 * read / Math.max(1, tried));
    }
}
