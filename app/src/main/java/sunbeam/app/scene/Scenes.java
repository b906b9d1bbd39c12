package sunbeam.app.scene;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Quoted;

/** Finds scenes by built-in name or file name. */
public final class Scenes {
    private static final List<String> NAMES = List.of(
            "close-up",
            "disc",
            "elaphe",
            "elaphe-body",
            "elaphe-scales",
            "xenopeltis",
            "xenopeltis-body",
            "xenopeltis-scales",
            "light-left",
            "light-above",
            "light-right");

    private Scenes() {}

    /** Returns the names (data/scenes). */
    public static List<String> builtIn() {
        return NAMES;
    }

    /**
     * Loads a built-in scene or a file; one with a built-in name needs its folder: {@code ./elaphe}.
     *
     * @throws InputException if there is no such scene, or the file is not a scene
     */
    public static Scene load(String nameOrFile) {
        if (NAMES.contains(nameOrFile)) {
            return builtIn(nameOrFile);
        }
        Path file = path(nameOrFile);
        if (!Files.exists(file)) {
            throw new InputException((nameOrFile.endsWith(".json") ? "there is no file " : "there is no scene ")
                    + Quoted.of(nameOrFile) + "; name a scene file (.json), or one of " + String.join(", ", NAMES));
        }
        return SceneReader.read(file);
    }

    /** Returns a JPEG of 48 x 36 pixels. */
    public static URL picture(String name) {
        return Scenes.class.getClassLoader().getResource("sunbeam/scenes/" + name + ".jpg");
    }

    private static Path path(String name) {
        try {
            return Path.of(name);
        } catch (InvalidPathException broken) {
            throw new InputException(
                    "scene " + Quoted.of(name) + " is no file name (" + broken.getReason() + ")", broken);
        }
    }

    private static Scene builtIn(String name) {
        String resource = "sunbeam/scenes/" + name + ".json";
        try (InputStream stream = Scenes.class.getClassLoader().getResourceAsStream(resource)) {
            if (stream == null) {
                throw new IllegalStateException("built without " + resource);
            }
            return SceneReader.readBuiltIn(name + ".json", stream);
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot read " + resource, failure);
        }
    }
}
