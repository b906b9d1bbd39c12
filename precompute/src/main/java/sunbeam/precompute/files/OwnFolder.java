package sunbeam.precompute.files;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/** Folder of an untrusted file, which may name no files elsewhere. */
public record OwnFolder(Path owner, String kind) {
    /** Resolves a name; the file need not exist. Throws IllegalArgumentException if it is invalid or leads out. */
    public Path file(String name) {
        Path relative;
        try {
            relative = Path.of(name);
        } catch (InvalidPathException broken) {
            throw new IllegalArgumentException("is no file name (" + broken.getReason() + "); mend it", broken);
        }
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

    /** Throws IllegalArgumentException if an existing file lies outside after all links are followed. */
    public void requireNoWayOut(Path file) {
        try {
            if (leaves(file, owner.toAbsolutePath().getParent())) {
                throw new IllegalArgumentException(
                        "is a link that leads out of the " + kind + "'s folder; copy the file there");
            }
        } catch (IOException failure) {
            throw new IllegalArgumentException(
                    "cannot be followed (" + failure.getMessage() + "); check the file", failure);
        }
    }

    /** True if an existing file lies outside of a folder after all links are followed; false if they cannot be followed. */
    public static boolean isWayOut(Path file, Path folder) {
        try {
            return leaves(file, folder);
        } catch (IOException unfollowed) {
            return false;
        }
    }

    private static boolean leaves(Path file, Path folder) throws IOException {
        return !file.toRealPath().startsWith(folder.toRealPath());
    }
}
