package sunbeam.app.scene;

import java.nio.file.Path;
import java.util.Optional;
import sunbeam.app.files.output.OutputException;

/** How a scene's files are written down: relative to the scene's folder, absolutely, or without folders. */
final class SceneNames {
    private final Optional<Path> folder;
    private final boolean shown;

    private SceneNames(Optional<Path> folder, boolean shown) {
        this.folder = folder;
        this.shown = shown;
    }

    static SceneNames relativeTo(Path sceneFile) {
        return new SceneNames(Optional.of(sceneFile.toAbsolutePath().normalize().getParent()), false);
    }

    static SceneNames absolute() {
        return new SceneNames(Optional.empty(), false);
    }

    /** For pictures that are shown to others, whom folders do not concern. */
    static SceneNames withoutFolders() {
        return new SceneNames(Optional.empty(), true);
    }

    /** Built-in names stay as they are; they are no absolute paths. */
    String of(String name) {
        Path path = Path.of(name);
        if (shown && path.isAbsolute()) {
            return String.valueOf(path.getFileName());
        }
        if (folder.isEmpty() || !path.isAbsolute()) {
            return name;
        }
        if (!path.normalize().startsWith(folder.get())) {
            throw new OutputException("the scene uses " + path + ", which is not in the scene's folder " + folder.get()
                    + "; copy it there and load it from there first");
        }
        return folder.get().relativize(path.normalize()).toString();
    }
}
