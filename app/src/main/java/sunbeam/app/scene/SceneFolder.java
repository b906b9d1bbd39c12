package sunbeam.app.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

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
     * What a setting names, as {@link #resolve(String, List)} has it.
     *
     * @throws sunbeam.precompute.setting.SettingException if it is nothing, in the words of the place where it was chosen
     */
    String resolve(Choices choices, Setting<String> setting, List<String> builtIn) {
        try {
            return resolve(choices.get(setting), builtIn);
        } catch (IllegalArgumentException wrong) {
            throw choices.complaint(setting, wrong.getMessage());
        }
    }

    /**
     * A built-in name as it is, or the absolute name of a file.
     *
     * @throws IllegalArgumentException if it is neither, with a message that continues "the name ..."
     */
    private String resolve(String name, List<String> builtIn) {
        if (builtIn.contains(name)) {
            return name;
        }
        if (folder.isEmpty() || name.isBlank()) {
            throw new IllegalArgumentException("is not one of " + String.join(", ", builtIn));
        }
        Path file = inside(name);
        if (!Files.exists(file)) {
            throw new IllegalArgumentException("is no file: there is no " + file + "; check the name, or take one of "
                    + String.join(", ", builtIn));
        }
        requireNoWayOut(file);
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
                throw new IllegalArgumentException(
                        "leads out of the scene's folder; name a file in it, without .. or leading /");
            }
            return folder.orElseThrow().resolve(relative).normalize();
        } catch (InvalidPathException broken) {
            throw new IllegalArgumentException("is no file name (" + broken.getReason() + "); mend it", broken);
        }
    }

    private void requireNoWayOut(Path file) {
        try {
            if (!file.toRealPath().startsWith(folder.orElseThrow().toRealPath())) {
                throw new IllegalArgumentException(
                        "is a link that leads out of the scene's folder; copy the file there");
            }
        } catch (IOException failure) {
            throw new IllegalArgumentException(
                    "cannot be followed (" + failure.getMessage() + "); check the file", failure);
        }
    }
}
