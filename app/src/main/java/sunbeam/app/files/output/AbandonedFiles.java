package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.CRC32;

/**
 * Temporary files of outputs: {@code .sunbeam-MACHINE-PROCESS-NUMBER.part}. What a killed process left is removed: on this
 * machine when no such process runs any more, of other machines, which may share the folder, when nobody has written to it
 * for a week.
 */
final class AbandonedFiles {
    private static final Duration LONG_AGO = Duration.ofDays(7);
    /** A process that started later than this after the last writing is another one of the same number. */
    private static final Duration CLOCK_SLACK = Duration.ofMinutes(1);

    private static final Pattern NAME = Pattern.compile("\\.sunbeam-(?:([0-9a-f]{8})-)?(\\d{1,18})-\\d{1,9}\\.part");
    /** Numbers of processes mean something within one start of one machine, and there within one container. */
    private static final Path BOOT = Path.of("/proc/sys/kernel/random/boot_id");

    private static final Path CONTAINER = Path.of("/proc/self/ns/pid");
    private static final String UNKNOWN = "00000000";

    private AbandonedFiles() {}

    /**
     * Makes a new, empty temporary file. Not Files.createTempFile: that makes files which only their owner may read, and
     * they are the output later.
     */
    static Path create(Path folder) throws IOException {
        String stem = ".sunbeam-" + machine() + "-" + ProcessHandle.current().pid() + "-";
        for (int number = 0; ; number++) {
            Path candidate = folder.resolve(stem + number + ".part");
            try {
                return Files.createFile(candidate);
            } catch (FileAlreadyExistsException taken) {
                // Another output of this process, or left by one that was killed: take the next number.
            } catch (IOException failure) {
                // The name is this process's alone: should it be there nevertheless, nobody else needs it.
                Files.deleteIfExists(candidate);
                throw failure;
            }
        }
    }

    /** Removes what was abandoned in a folder; what cannot be removed, or even listed, stays: it harms nobody. */
    static void sweep(Path folder) {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, ".sunbeam-*.part")) {
            String here = machine();
            for (Path file : files) {
                removeIfAbandoned(file, here);
            }
        } catch (IOException | DirectoryIteratorException unlistable) {
            return;
        }
    }

    private static void removeIfAbandoned(Path file, String here) {
        Matcher name = NAME.matcher(file.getFileName().toString());
        try {
            if (name.matches() && isAbandoned(file, name.group(1), Long.parseLong(name.group(2)), here)) {
                Files.deleteIfExists(file);
            }
        } catch (IOException inUse) {
            return;
        }
    }

    private static boolean isAbandoned(Path file, String machine, long process, String here) throws IOException {
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        Instant written = Files.getLastModifiedTime(file).toInstant();
        if (!here.equals(machine) || here.equals(UNKNOWN)) {
            return written.isBefore(Instant.now().minus(LONG_AGO));
        }
        Optional<ProcessHandle> running = ProcessHandle.of(process);
        Optional<Instant> start = running.flatMap(handle -> handle.info().startInstant());
        return running.isEmpty()
                || start.map(instant -> instant.isAfter(written.plus(CLOCK_SLACK)))
                        .orElse(false);
    }

    /** Eight hexadecimal digits for where the numbers of processes are this process's own; zeros where nobody knows. */
    static String machine() {
        try {
            String container = Files.readSymbolicLink(CONTAINER).toString();
            CRC32 sum = new CRC32();
            sum.update((Files.readString(BOOT).strip() + container).getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().toHexDigits((int) sum.getValue());
        } catch (IOException | UnsupportedOperationException elsewhere) {
            return UNKNOWN;
        }
    }
}
