package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Folders that commands write several files into. */
public final class OutputFolder {
    private OutputFolder() {}

    /**
     * Makes the folder where it is missing; its parent must be there.
     *
     * @throws OutputException when it cannot be made, or a file is in its place
     */
    public static void create(Path folder) {
        try {
            if (!Files.isDirectory(folder)) {
                Files.createDirectory(folder);
            }
        } catch (IOException failure) {
            throw new OutputException(
                    "cannot make the folder " + folder + " (" + reason(failure) + "); name another with --output",
                    failure);
        }
    }

    /**
     * Tells early whether the folder is there or could be made, as far as can be known without making it.
     *
     * @throws OutputException when not
     */
    public static void check(Path folder) {
        Path above = folder.toAbsolutePath().getParent();
        if (Files.exists(folder) || above == null || !Files.isDirectory(above)) {
            create(folder);
        }
    }

    /** In words; what Java says of these is the folder's name. */
    private static String reason(IOException failure) {
        if (failure instanceof FileAlreadyExistsException) {
            return "a file has this name";
        }
        if (failure instanceof AccessDeniedException) {
            return "permission denied";
        }
        return failure instanceof NoSuchFileException ? "the folder above it does not exist" : failure.getMessage();
    }
}
