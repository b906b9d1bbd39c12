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
        requireFolder(folder);
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
     * Makes the folder, or where others have made one of its name meanwhile and it may not be used, the next of
     * {@code folder-2}, {@code folder-3} and so on.
     *
     * @param mayUse whether a folder that is there will do
     * @return the folder
     * @throws OutputException when it cannot be made
     */
    public static Path claim(Path folder, boolean mayUse) {
        NumberedNames names = NumberedNames.ofFolder(folder);
        for (int number = 1; !mayUse && number <= NumberedNames.MOST; number++) {
            try {
                return Files.createDirectory(names.name(number));
            } catch (FileAlreadyExistsException taken) {
                // The next number, then.
            } catch (IOException failure) {
                break;
            }
        }
        create(folder);
        return folder;
    }

    private static void requireFolder(Path folder) {
        if (StandardOutput.isMeant(folder)) {
            throw new OutputException(
                    "cannot write several files to standard output: name a folder, or ./- for one of the name -");
        }
    }

    /**
     * Tells early whether the folder is there or could be made, as far as can be known without making it.
     *
     * @throws OutputException when not
     */
    public static void check(Path folder) {
        requireFolder(folder);
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
