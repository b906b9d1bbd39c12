package sunbeam.app.scene;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.text.Quoted;

/** The files that a scene may name: those in its folder and below. */
record SceneFolder(Optional<OwnFolder> folder) {

    /** A scene's folder. */
    static SceneFolder of(Path sceneFile) {
        return new SceneFolder(Optional.of(new OwnFolder(sceneFile.toAbsolutePath(), "scene")));
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
        Path file = folder.get().file(name).normalize();
        if (!Files.exists(file)) {
            throw new IllegalArgumentException(Quoted.of(name) + ": there is no file " + file
                    + "; check the name, or take one of " + String.join(", ", builtIn));
        }
        folder.get().requireNoWayOut(name, file);
        return file.toString();
    }
}
