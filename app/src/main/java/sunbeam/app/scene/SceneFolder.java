package sunbeam.app.scene;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Folder of a scene: the scene may name files in it and below. */
record SceneFolder(Optional<OwnFolder> folder) {

    static SceneFolder of(Path sceneFile) {
        return new SceneFolder(Optional.of(new OwnFolder(sceneFile.toAbsolutePath(), "scene")));
    }

    static SceneFolder none() {
        return new SceneFolder(Optional.empty());
    }

    /** Returns choices with the file name of one setting made absolute, unless it is a built-in name. */
    Choices resolve(Choices choices, Setting<String> setting, List<String> builtIn) {
        try {
            return choices.with(setting, resolve(choices.get(setting), builtIn), choices.origin(setting));
        } catch (IllegalArgumentException wrong) {
            throw choices.complaint(setting, wrong.getMessage());
        }
    }

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
