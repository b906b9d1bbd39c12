package sunbeam.precompute.files;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/**
 * Restricts the files that an untrusted file may name to its own folder and below.
 *
 * @param kind kind of the file in messages, such as {@code scene}
 */
public record OwnFolder(Path owner, String kind) {

    /**
     * Resolves a name; the file need not exist.
     *
     * @throws IllegalArgumentException if the name is invalid or leads out of the folder
     */
    public Path file(String name) {
        Path relative = parsed(name);
        boolean leaves = relative.isAbsolute() || relative.getRoot() != null;
        for (Path part : relative) {
            leaves |= part.toString().equals("..");
        }
        if (leaves) {
            throw new IllegalArgumentException(
                    "leads out of the " + kind + "'s own folder; name a file in it, without .. or leading /");
        }
        return owner.resolveSibling(relative);
    }

    /**
     * Requires that an existing file lies in the folder or below after all links are followed.
     *
     * @throws IllegalArgumentException if the links lead out of the folder or cannot be followed
     */
    public void requireNoWayOut(Path file) {
        try {
            Path folder = owner.toAbsolutePath().getParent().toRealPath();
            if (!file.toRealPath().startsWith(folder)) {
                throw new IllegalArgumentException(
                        "is a link that leads out of the " + kind + "'s folder; copy the file there");
            }
        } catch (IOException failure) {
            throw new IllegalArgumentException(
                    "cannot be followed (" + failure.getMessage() + "); check the file", failure);
        }
    }

    private static Path parsed(String name) {
        try {
            return Path.of(name);
        } catch (InvalidPathException broken) {
            throw new IllegalArgumentException("is no file name (" + broken.getReason() + "); mend it", broken);
        }
    }
}
