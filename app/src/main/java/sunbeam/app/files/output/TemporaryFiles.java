package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;

/** Temporary files of outputs, {@code .sunbeam-PROCESS-NUMBER.part}. What a killed process left is removed after a day. */
final class TemporaryFiles {
    /** Nobody writes an output for a day without adding to it; processes of other machines may share the folder. */
    private static final Duration LONG_AGO = Duration.ofDays(1);

    private TemporaryFiles() {}

    /**
     * Makes a new, empty one. Not Files.createTempFile: that makes files which only their owner may read, and they are the
     * output later.
     */
    static Path create(Path folder) throws IOException {
        String stem = ".sunbeam-" + ProcessHandle.current().pid() + "-";
        for (int number = 0; ; number++) {
            Path candidate = folder.resolve(stem + number + ".part");
            try {
                return Files.createFile(candidate);
            } catch (FileAlreadyExistsException taken) {
                // Another output of this process, or of one of the same number: take the next.
            } catch (IOException failure) {
                Files.deleteIfExists(candidate);
                throw failure;
            }
        }
    }

    /** Removes what was abandoned in a folder; what cannot be removed, or even listed, stays: it harms nobody. */
    static void sweep(Path folder) {
        Instant longAgo = Instant.now().minus(LONG_AGO);
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, ".sunbeam-[0-9]*-[0-9]*.part")) {
            for (Path file : files) {
                if (Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                        && Files.getLastModifiedTime(file).toInstant().isBefore(longAgo)) {
                    Files.deleteIfExists(file);
                }
            }
        } catch (IOException | DirectoryIteratorException unlistable) {
            return;
        }
    }
}
