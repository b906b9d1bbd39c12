package sunbeam.app.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.text.Quoted;

/** The files that a scene may name: those in its folder and below. A scene may come from anywhere. */
final class SceneFolder {
    private final Optional<Path> folder;

    private SceneFolder(Optional<Path> folder) {
        this.folder = folder;
    }

    /** A scene's folder. */
    static SceneFolder of(Path sceneFile) {
        return new SceneFolder(Optional.of(sceneFile.toAbsolutePath().getParent()));
    }

    /** Built-in scenes have none. */
    static SceneFolder none() {
        return new SceneFolder(Optional.empty());
    }

    /**
     * A built-in name as it is, or the absolute name of a file.
     *
     * @throws IllegalArgumentException if it is neither, with a message for the user
     */
    String resolve(String name, List<String> builtIn) {
        if (builtIn.contains(name)) {
            return name;
        }
        if (folder.isEmpty() || name.isBlank()) {
            throw new IllegalArgumentException(Quoted.of(name) + " is not one of " + String.join(", ", builtIn));
        }
        Path file = inside(name);
        if (!Files.exists(file)) {
            throw new IllegalArgumentException(Quoted.of(name) + ": there is no file " + file
                    + "; check the name, or take one of " + String.join(", ", builtIn));
        }
        requireNoWayOut(name, file);
        return file.toString();
    }

    private Path inside(String name) {
        try {
            Path relative = Path.of(name);
            boolean leaves = relative.isAbsolute() || relative.getRoot() != null;
            for (Path part : relative) {
                leaves |= part.toString().equals("..");
            }
            if (leaves) {
                throw new IllegalArgumentException(Quoted.of(name)
                        + " leads out of the scene's folder; name a file in it, without .. or leading /");
            }
            return folder.orElseThrow().resolve(relative).normalize();
        } catch (InvalidPathException broken) {
            throw new IllegalArgumentException(
                    Quoted.of(name) + " is no file name (" + broken.getReason() + "); mend it", broken);
        }
    }

    private void requireNoWayOut(String name, Path file) {
        try {
            if (!file.toRealPath().startsWith(folder.orElseThrow().toRealPath())) {
                throw new IllegalArgumentException(
                        Quoted.of(name) + " is a link that leads out of the scene's folder; copy the file there");
            }
        } catch (IOException failure) {
            throw new IllegalArgumentException(
                    Quoted.of(name) + " cannot be followed (" + failure.getMessage() + "); check the file", failure);
        }
    }
}
