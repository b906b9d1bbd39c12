package sunbeam.app.scene;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** The files that a scene may name: those in its folder and below. */
record SceneFolder(Optional<OwnFolder> folder) {

    static SceneFolder of(Path sceneFile) {
        return new SceneFolder(Optional.of(new OwnFolder(sceneFile.toAbsolutePath(), "scene")));
    }

    /** Built-in scenes have none. */
    static SceneFolder none() {
        return new SceneFolder(Optional.empty());
    }

    /** Choices of which one names a file, which is absolute then, or something built in. */
    Choices resolve(Choices choices, Setting<String> setting, List<String> builtIn) {
        try {
            return choices.with(setting, resolve(choices.get(setting), builtIn), choices.origin(setting));
        } catch (IllegalArgumentException wrong) {
            throw choices.complaint(setting, wrong.getMessage());
        }
    }

    /** As {@link #resolve(Choices, Setting, List)}, of an index, which may be in a file. */
    Choices resolveIndex(Choices choices) {
        SkinIndex index = choices.get(SceneSettings.INDEX);
        try {
            return index.isByWavelength()
                    ? choices.with(SceneSettings.INDEX, SkinIndex.of(resolve(index.file(), List.of())))
                    : choices;
        } catch (IllegalArgumentException wrong) {
            throw choices.complaint(SceneSettings.INDEX, wrong.getMessage());
        }
    }

    /** A built-in name as it is, or the absolute name of a file. */
    private String resolve(String name, List<String> builtIn) {
        if (builtIn.contains(name)) {
            return name;
        }
        if (folder.isEmpty() || name.isBlank()) {
            throw new IllegalArgumentException(
                    builtIn.isEmpty()
                            ? "names a file, which built-in scenes do not"
                            : "is not one of " + list(builtIn));
        }
        Path file = folder.get().file(name).normalize();
        if (!Files.exists(file)) {
            throw new IllegalArgumentException("is no file: there is no " + file + "; check the name"
                    + (builtIn.isEmpty() ? "" : ", or take one of " + list(builtIn)));
        }
        folder.get().requireNoWayOut(file);
        return file.toString();
    }

    private static String list(List<String> names) {
        return String.join(", ", names);
    }
}
