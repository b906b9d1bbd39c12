package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.function.Supplier;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;

/** Folders that commands write several files into. */
public final class OutputFolder {
    private static final int HOOK_TRIES = 50;
    private static final int HOOK_WAIT_MILLISECONDS = 10;

    private OutputFolder() {}

    /**
     * Creates the folder if it is missing; its parent must exist.
     *
     * @throws OutputException if it cannot be created, or a file is in its place
     */
    public static void create(Path folder) {
        requireFolder(folder);
        try {
            if (!Files.isDirectory(folder)) {
                Files.createDirectory(folder);
            }
        } catch (IOException failure) {
            throw unmade(folder, failure);
        }
    }

    /**
     * Creates the folder if it is missing, and writes into it. A new folder that stays empty is removed, also at the end of the process
     * (Ctrl-C).
     *
     * @param writer writer of the files, which removes unfinished ones
     * @throws OutputException when it cannot be made
     */
    public static <T> T filled(Path folder, Supplier<T> writer) {
        boolean isNew = !Files.exists(folder);
        create(folder);
        ShutdownHook hook = new ShutdownHook(() -> removeOnceEmpty(folder, isNew ? HOOK_TRIES : 0));
        try {
            return writer.get();
        } finally {
            hook.close();
            removeOnceEmpty(folder, isNew ? 1 : 0);
        }
    }

    /** Removes the folder once it is empty: the hooks of its files, which run in any order, empty it. */
    private static void removeOnceEmpty(Path folder, int tries) {
        try {
            for (int i = 0;
                    i < tries && folder.toFile().exists() && !folder.toFile().delete();
                    i++) {
                Thread.sleep(tries > 1 ? HOOK_WAIT_MILLISECONDS : 0);
            }
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    private static OutputException unmade(Path folder, IOException failure) {
        return new OutputException(
                "cannot make the folder " + folder + " (" + reason(failure) + "); name another with --output", failure);
    }

    /**
     * Makes the folder, or where others have made one of its name meanwhile and it may not be used, the next of {@code folder-2}, {@code
     * folder-3} and so on.
     *
     * @param mayUse whether a folder that is there will do
     * @return the folder
     * @throws OutputException if it cannot be created
     */
    public static Path claim(Path folder, boolean mayUse) {
        int most = mayUse ? 0 : TargetFolder.MOST_NAMES;
        try {
            for (int number = 1; number <= most; number++) {
                Path name = TargetFolder.numberedAtEnd(folder, number);
                if (isMade(name)) {
                    return name;
                }
            }
        } catch (IOException failure) {
            throw unmade(folder, failure);
        }
        create(folder);
        return folder;
    }

    private static boolean isMade(Path folder) throws IOException {
        try {
            Files.createDirectory(folder);
            return true;
        } catch (FileAlreadyExistsException taken) {
            return false;
        }
    }

    private static void requireFolder(Path folder) {
        if (StandardOutput.isMeant(folder)) {
            throw new UsageException(
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
