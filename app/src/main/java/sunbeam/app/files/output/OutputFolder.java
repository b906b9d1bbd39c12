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

/** Creation of folders for commands that write several files. */
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
            throw creationFailure(folder, failure);
        }
    }

    /** Creates the folder and its parents. */
    public static void createWithParents(Path folder) {
        Path above = folder.toAbsolutePath().getParent();
        if (above != null && !Files.exists(above)) {
            createWithParents(above);
        }
        create(folder);
    }

    /**
     * Creates the folder if it is missing, and runs the writer. A new folder that stays empty is removed, also if the process is ended
     * (Ctrl-C).
     *
     * @param writer writer of the files, which itself removes unfinished ones
     * @throws OutputException if the folder cannot be created
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

    /** Removes the folder once it is empty. It may have to wait for the shutdown hooks of the folder's files, which run in any order. */
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

    private static OutputException creationFailure(Path folder, IOException failure) {
        return new OutputException(
                "cannot make the folder " + folder + " (" + reason(failure) + "); name another with --output", failure);
    }

    /**
     * Creates the folder. If it exists and may not be used, creates the first free one of {@code folder-2}, {@code folder-3} and so on.
     *
     * @param mayUse whether an existing folder may be used
     * @throws OutputException if no folder can be created
     */
    public static Path claim(Path folder, boolean mayUse) {
        int most = mayUse ? 0 : TargetFolder.MOST_NAMES;
        for (int number = 1; number <= most; number++) {
            try {
                return Files.createDirectory(TargetFolder.numberedAtEnd(folder, number));
            } catch (FileAlreadyExistsException taken) {
                // The next number may be free.
            } catch (IOException failure) {
                throw creationFailure(folder, failure);
            }
        }
        create(folder);
        return folder;
    }

    private static void requireFolder(Path folder) {
        if (StandardOutput.isMeant(folder)) {
            throw new UsageException(
                    "cannot write several files to standard output: name a folder, or ./- for one of the name -");
        }
    }

    /**
     * Checks before a long computation that the folder exists or can probably be created, without creating it where its parent exists.
     *
     * @throws OutputException if the folder cannot be created
     */
    public static void check(Path folder) {
        requireFolder(folder);
        Path above = folder.toAbsolutePath().getParent();
        if (Files.exists(folder) || above == null || !Files.isDirectory(above)) {
            create(folder);
        }
    }

    /** Java's message is only the folder's name. */
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
