package sunbeam.app.fuzz;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import sunbeam.app.failure.Failure;

/**
 * Fuzz target that gives inputs to one reader. An input passes if it is read, or refused by an exception with a line for the user. An
 * exception that the program would report as its own bug, or more than 5 s of processor time, is a finding. The virtual machine has 512 MB
 * of heap.
 */
public final class FuzzTarget {
    static final String READER = "sunbeam.fuzz.reader";

    static final Duration MOST_TIME = Duration.ofSeconds(5);

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private static FuzzTarget chosen;

    private final FuzzedReader reader;
    private final Path file;

    /** Returns a start of Java with the budget's memory and the tests' classes. */
    static ProcessBuilder java(String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx512m",
                "-Djava.awt.headless=true",
                "-Dslf4j.internal.verbosity=ERROR",
                "-cp",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"))));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }

    FuzzTarget(FuzzedReader reader, Path folder) {
        this.reader = reader;
        this.file = folder.resolve(reader.fileName());
    }

    /** Called by Jazzer for each input, for the reader that the system property {@link #READER} names. */
    public static void fuzzerTestOneInput(byte[] input) throws IOException {
        if (chosen == null) {
            Path folder = Files.createTempDirectory("sunbeam-fuzz");
            chosen = new FuzzTarget(FuzzedReader.of(System.getProperty(READER)), folder);
        }
        chosen.assertReadOrRefusedInTime(input);
    }

    /**
     * Asserts that the reader reads an input, or refuses it with a message, within {@link #MOST_TIME}.
     *
     * @throws AssertionError for a finding
     */
    void assertReadOrRefusedInTime(byte[] input) throws IOException {
        Files.write(file, input);
        long start = THREADS.getCurrentThreadCpuTime();
        try {
            reader.read(file);
        } catch (RuntimeException | IOException refused) {
            Failure failure = Failure.of(refused);
            if (failure.isBug() || failure.message().contains("\n")) {
                throw new AssertionError(reader.label() + ": " + refused, refused);
            }
        }
        Duration taken = Duration.ofNanos(THREADS.getCurrentThreadCpuTime() - start);
        if (taken.compareTo(MOST_TIME) > 0) {
            throw new AssertionError(reader.label() + " took " + taken + " of a processor");
        }
    }
}
