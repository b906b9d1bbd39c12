package sunbeam.app.files.output;

import java.io.IOException;
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

/** The folder of an output: what stands there, which names are free, and temporary files in it. */
final class TargetFolder {
    /** Nobody writes an output for a day without adding to it; processes of other machines may share the folder. */
    private static final Duration LONG_AGO = Duration.ofDays(1);

    static final int MOST_NAMES = 10_000;

    private static final LinkOption[] FOLLOWING = {};
    private static final LinkOption[] NOT_FOLLOWING = {LinkOption.NOFOLLOW_LINKS};

    private TargetFolder() {}

    static Path of(Path target) {
        Path folder = target.toAbsolutePath().getParent();
        return folder != null ? folder : target.toAbsolutePath();
    }

    /** @throws OutputException when the target is a folder, exists and may not be replaced, or its folder is missing */
    static void check(Path target, Overwrite overwrite) {
        if (StandardOutput.isMeant(target)) {
            return;
        }
        if (Files.isDirectory(target)) {
            throw new OutputException("cannot write " + target + ": it is a folder; name a file in it");
        }
        Path folder = of(target);
        if (!Files.exists(folder)) {
            throw new OutputException(
                    "cannot write " + target + ": the folder " + folder + " does not exist; create it first");
        }
        if (!Files.isDirectory(folder)) {
            throw new OutputException("cannot write " + target + ": " + folder + " is not a folder");
        }
        if (!Files.exists(target, LinkOption.NOFOLLOW_LINKS) || isDevice(target)) {
            return;
        }
        if (overwrite == Overwrite.REFUSE) {
            throw OutputException.of(target, new FileAlreadyExistsException(target.toString()));
        }
        if (overwrite == Overwrite.REPLACE && !Files.isSymbolicLink(target) && !Files.isWritable(target)) {
            throw new OutputException("cannot write " + target + ": it is write-protected; choose another name");
        }
    }

    /**
     * Whether the target is written in place. One look, whose failure is told: a file that is taken for a device would be
     * written over. In a folder where everybody may write, a link to a device may be another user's: it is replaced.
     */
    static boolean isDevice(Path target) {
        try {
            LinkOption[] links = isEverybodys(of(target)) ? NOT_FOLLOWING : FOLLOWING;
            return Files.readAttributes(target, BasicFileAttributes.class, links)
                    .isOther();
        } catch (NoSuchFileException free) {
            return false;
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    private static boolean isEverybodys(Path folder) throws IOException {
        return Files.getFileStore(folder).supportsFileAttributeView("posix")
                && Files.getPosixFilePermissions(folder).contains(PosixFilePermission.OTHERS_WRITE);
    }

    /**
     * The names that an output may take which the user did not name: {@code blaze.png}, {@code blaze-2.png} and so on.
     */
    static Path numbered(Path plain, int number) {
        String name = plain.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return numbered(plain, number, dot > 0 ? dot : name.length());
    }

    /** As {@link #numbered(Path, int)}, of a folder or a stem: the number stands at the end. */
    static Path numberedAtEnd(Path plain, int number) {
        return numbered(plain, number, plain.getFileName().toString().length());
    }

    private static Path numbered(Path plain, int number, int at) {
        String name = plain.getFileName().toString();
        return number == 1 ? plain : plain.resolveSibling(name.substring(0, at) + "-" + number + name.substring(at));
    }

    /** @throws OutputException unless another name is to be tried after the one of a number, which was taken */
    static void requireNext(Overwrite overwrite, Path name, int number, FileAlreadyExistsException taken) {
        if (overwrite != Overwrite.NUMBER) {
            throw OutputException.of(name, taken);
        }
        if (number == MOST_NAMES) {
            throw new OutputExistsException(
                    "cannot write " + name + ": so many exist already; name one with --output, or add --force");
        }
    }

    /**
     * Makes a new, empty file, {@code .sunbeam-PROCESS-NUMBER.part}. Not Files.createTempFile: that makes files which only
     * their owner may read, and they are the output later.
     */
    static Path createTemporary(Path folder) throws IOException {
        String stem = ".sunbeam-" + ProcessHandle.current().pid() + "-";
        for (int number = 0; ; number++) {
            try {
                return Files.createFile(folder.resolve(stem + number + ".part"));
            } catch (FileAlreadyExistsException taken) {
                // Another output of this process, or of one of the same number: take the next.
            }
        }
    }

    /** Gives a new, empty file the permissions of the file that it will replace, if there is one. */
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

    /** Removes what killed processes left; what cannot be removed, or even listed, stays: it harms nobody. */
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
