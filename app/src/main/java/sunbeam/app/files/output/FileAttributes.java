package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/**
 * Who may read and write a file that is replaced: the new one is given the same mode, and the same owner and group where
 * this user may give them. Where the group cannot be kept, its rights are withdrawn, lest they fall to another group.
 * Access control lists and extended attributes are not carried over.
 */
final class FileAttributes {
    private static final Set<PosixFilePermission> OF_GROUP = EnumSet.of(
            PosixFilePermission.GROUP_READ, PosixFilePermission.GROUP_WRITE, PosixFilePermission.GROUP_EXECUTE);
    private static final Set<PosixFilePermission> OWNER_ONLY =
            EnumSet.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);

    private final PosixFileAttributes replaced;

    private FileAttributes(PosixFileAttributes replaced) {
        this.replaced = replaced;
    }

    /** Those of an existing file; nothing where the file system has none. */
    static Optional<FileAttributes> of(Path file) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        return view == null ? Optional.empty() : Optional.of(new FileAttributes(view.readAttributes()));
    }

    /** While its content is written, nobody else reads a file that replaces one which others may not read. */
    static void hide(Path file) throws IOException {
        Files.setPosixFilePermissions(file, OWNER_ONLY);
    }

    /** Gives a file what these attributes say. */
    void giveTo(Path file) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        PosixFileAttributes own = view.readAttributes();
        Set<PosixFilePermission> permissions = EnumSet.noneOf(PosixFilePermission.class);
        permissions.addAll(replaced.permissions());
        if (!own.group().equals(replaced.group()) && !mayGive(() -> view.setGroup(replaced.group()))) {
            permissions.removeAll(OF_GROUP);
        }
        if (!own.owner().equals(replaced.owner())) {
            mayGive(() -> view.setOwner(replaced.owner()));
        }
        view.setPermissions(permissions);
    }

    private interface Gift {
        void give() throws IOException;
    }

    /** Only the superuser gives files away, and others give them to groups of theirs only: no failure of the output. */
    private static boolean mayGive(Gift gift) {
        try {
            gift.give();
            return true;
        } catch (IOException refused) {
            return false;
        }
    }
}
