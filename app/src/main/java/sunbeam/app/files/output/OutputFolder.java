package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.time.Duration;
import java.time.Instant;
import java.util.function.Supplier;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;

/** Folders of outputs: their creation, checks, free names and temporary files. */
public final class OutputFolder {
    private static final int HOOK_TRIES = 50;
    private static final int HOOK_WAIT_MILLISECONDS = 10;
    // Age of abandoned temporary files. Other machines may share the folder, so process numbers do not tell.
    private static final Duration LONG_AGO = Duration.ofDays(1);

    static final int MOST_NAMES = 10_000;

    private OutputFolder() {}

    /** True for {@code -}; a file of this name is {@code ./-}. */
    public static boolean isStandardOutput(Path target) {
        return Path.of("-").equals(target);
    }

    public static String name(Path target) {
        return isStandardOutput(target) ? "written to standard output" : Text.oneLine(target.toString());
    }

    /** Creates a missing folder in an existing one; throws {@link OutputException} if it cannot. */
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

    public static void createWithParents(Path folder) {
        Path above = folder.toAbsolutePath().getParent();
        if (above != null && !Files.exists(above)) {
            createWithParents(above);
        }
        create(folder);
    }

    /** Creates a missing folder for the writer's files; a new one that stays empty is removed, also on Ctrl-C. */
    public static <T> T filled(Path folder, Supplier<T> writer) {
        boolean isNew = !Files.exists(folder);
        create(folder);
        if (!isNew) {
            return writer.get();
        }
        ShutdownHook hook = new ShutdownHook(() -> removeOnceEmpty(folder));
        try {
            return writer.get();
        } finally {
            hook.close();
            folder.toFile().delete();
        }
    }

    /** Waits for the shutdown hooks of the folder's files, which run in any order. */
    private static void removeOnceEmpty(Path folder) {
        try {
            var file = folder.toFile();
            for (int i = 0; i < HOOK_TRIES && file.exists() && !file.delete(); i++) {
                Thread.sleep(HOOK_WAIT_MILLISECONDS);
            }
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    private static OutputException creationFailure(Path folder, IOException failure) {
        return new OutputException(
                "cannot make the folder " + folder + " (" + reason(failure) + "); name another with --output", failure);
    }

    /** Creates the folder, or the first free one of {@code folder-2} and so on if it may not be used; throws {@link OutputException}. */
    public static Path claim(Path folder, boolean mayUse) {
        for (int number = 1; !mayUse && number <= MOST_NAMES; number++) {
            try {
                return Files.createDirectory(numberedAtEnd(folder, number));
            } catch (FileAlreadyExistsException taken) {
                // The next may be free.
            } catch (IOException failure) {
                throw creationFailure(folder, failure);
            }
        }
        create(folder);
        return folder;
    }

    private static void requireFolder(Path folder) {
        UsageException.throwIf(
                isStandardOutput(folder),
                "cannot write several files to standard output: name a folder, or ./- for one of the name -");
    }

    /** Throws {@link OutputException} if the folder cannot be created; does not create it where its parent exists. */
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

    static Path of(Path target) {
        Path folder = target.toAbsolutePath().getParent();
        return folder != null ? folder : target.toAbsolutePath();
    }

    /** @throws OutputException if the target is a folder, exists and may not be replaced, or its folder is missing */
    static void checkTarget(Path target, Overwrite overwrite) {
        if (isStandardOutput(target)) {
            return;
        }
        OutputException.refuseIf(Files.isDirectory(target), target, "it is a folder; name a file in it");
        Path folder = of(target);
        String missing = "the folder " + folder + " does not exist; create it first";
        OutputException.refuseIf(!Files.exists(folder), target, missing);
        OutputException.refuseIf(!Files.isDirectory(folder), target, folder + " is not a folder");
        if (!Files.exists(target, LinkOption.NOFOLLOW_LINKS) || isDevice(target)) {
            return;
        }
        if (overwrite == Overwrite.REFUSE) {
            throw OutputException.of(target, new FileAlreadyExistsException(target.toString()));
        }
        boolean isProtected = !Files.isSymbolicLink(target) && !Files.isWritable(target);
        OutputException.refuseIf(
                overwrite == Overwrite.REPLACE && isProtected, target, "it is write-protected; choose another name");
    }

    /** True for a device, written in place. A link in a folder that all may write to is replaced: another user may have made it. */
    static boolean isDevice(Path target) {
        try {
            LinkOption[] links =
                    isWorldWritable(of(target)) ? new LinkOption[] {LinkOption.NOFOLLOW_LINKS} : new LinkOption[0];
            return Files.readAttributes(target, BasicFileAttributes.class, links)
                    .isOther();
        } catch (NoSuchFileException free) {
            return false;
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    private static boolean isWorldWritable(Path folder) throws IOException {
        return Files.getFileStore(folder).supportsFileAttributeView("posix")
                && Files.getPosixFilePermissions(folder).contains(PosixFilePermission.OTHERS_WRITE);
    }

    /** Returns {@code blaze.png}, {@code blaze-2.png} and so on. */
    static Path numbered(Path plain, int number) {
        String name = plain.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return numbered(plain, number, dot > 0 ? dot : name.length());
    }

    /** Returns the name of a folder or stem with a number. */
    static Path numberedAtEnd(Path plain, int number) {
        return numbered(plain, number, plain.getFileName().toString().length());
    }

    private static Path numbered(Path plain, int number, int at) {
        String name = plain.getFileName().toString();
        return number == 1 ? plain : plain.resolveSibling(name.substring(0, at) + "-" + number + name.substring(at));
    }

    /** Creates {@code .sunbeam-PROCESS-NUMBER.part}. Files.createTempFile would restrict reading to the owner. */
    static Path createTemporary(Path folder) throws IOException {
        String stem = ".sunbeam-" + ProcessHandle.current().pid() + "-";
        for (int number = 0; ; number++) {
            try {
                return Files.createFile(folder.resolve(stem + number + ".part"));
            } catch (FileAlreadyExistsException taken) {
                // Another output, or another machine's process of this number, has taken it.
            }
        }
    }

    static void copyMode(Path replaced, Path file) throws IOException {
        PosixFileAttributeView view =
                Files.getFileAttributeView(replaced, PosixFileAttributeView.class, LinkOption.NOFOLLOW_LINKS);
        if (view == null) {
            return;
        }
        try {
            PosixFileAttributes attributes = view.readAttributes();
            if (attributes.isRegularFile()) {
                Files.setPosixFilePermissions(file, attributes.permissions());
            }
        } catch (NoSuchFileException free) {
            return;
        }
    }

    /** Removes temporary files of killed processes; leftovers are harmless. */
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
