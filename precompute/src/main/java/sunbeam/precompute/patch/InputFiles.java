package sunbeam.precompute.patch;

import java.nio.file.Files;
import java.nio.file.Path;

/** What is checked of every file before it is opened. */
final class InputFiles {
    private InputFiles() {}

    /**
     * Nothing but an existing, readable, regular file passes; a device or a pipe could be read for ever.
     *
     * @throws PatchException that says which of these it is not
     */
    static void requireReadable(Path file) {
        if (!Files.exists(file)) {
            throw new PatchException(file + ": no such file; check the name and the folder");
        }
        if (Files.isDirectory(file)) {
            throw new PatchException(file + " is a folder; name the image, scan or descriptor (.json) in it");
        }
        if (!Files.isRegularFile(file)) {
            throw new PatchException(file + " is no regular file; copy the image, scan or descriptor to one");
        }
        if (!Files.isReadable(file)) {
            throw new PatchException(file + " cannot be read; check its permissions");
        }
    }

    /** The file's name without its folder and its last extension. */
    static String stem(Path file) {
        String name = String.valueOf(file.getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
