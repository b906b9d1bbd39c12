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

    /** A scene's folder. */
    static SceneFolder of(Path sceneFile) {
        return new SceneFolder(Optional.of(new OwnFolder(sceneFile.toAbsolutePath(), "scene")));
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
     * An index, whose file is absolute.
     *
     * @throws sunbeam.precompute.setting.SettingException if its file is none, in the words of the place where it was chosen
     */
    SkinIndex resolve(Choices choices, Setting<SkinIndex> setting) {
        SkinIndex index = choices.get(setting);
        try {
            return index.isByWavelength() ? SkinIndex.of(resolve(index.file(), List.of())) : index;
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
