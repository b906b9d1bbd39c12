package sunbeam.app.scene;

import static sunbeam.precompute.plan.MethodSettings.ILLUMINANT;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene.Viewpoint;
import sunbeam.app.scene.SceneSettings.SkinIndex;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.patch.PatchLoader.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.JsonObject;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Finds built-in scenes and reads scene files (docs/scenes.md); messages name file, line and key. */
public final class Scenes {
    private static final List<String> NAMES = List.of(("close-up disc elaphe elaphe-body elaphe-scales xenopeltis"
                    + " xenopeltis-body xenopeltis-scales light-left light-above light-right")
            .split(" ", -1));

    // Meters; also of a component of a direction.
    private static final double LARGEST_NUMBER = 1e6;

    private final JsonObject root;
    // Built-in scenes name no files, others those in their folder and below.
    private final Optional<OwnFolder> folder;

    private Scenes(JsonObject root, Optional<OwnFolder> folder) {
        this.root = root;
        this.folder = folder;
    }

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
        Path file;
        try {
            file = Path.of(nameOrFile);
        } catch (InvalidPathException broken) {
            String reason = " is no file name (" + broken.getReason() + ")";
            throw new InputException("scene " + Text.quoted(nameOrFile) + reason, broken);
        }
        if (!Files.exists(file)) {
            throw new InputException((nameOrFile.endsWith(".json") ? "there is no file " : "there is no scene ")
                    + Text.quoted(nameOrFile) + "; name a scene file (.json), or one of " + String.join(", ", NAMES));
        }
        return read(file);
    }

    /** Returns a JPEG of 48 x 36 pixels. */
    public static URL picture(String name) {
        return Scenes.class.getClassLoader().getResource("sunbeam/scenes/" + name + ".jpg");
    }

    private static Scene builtIn(String name) {
        String resource = "sunbeam/scenes/" + name + ".json";
        try (InputStream stream = Scenes.class.getClassLoader().getResourceAsStream(resource)) {
            return new Scenes(JsonObject.read(name + ".json", stream), Optional.empty()).scene();
        } catch (IOException failure) {
            throw new UncheckedIOException("cannot read " + resource, failure);
        }
    }

    /** Reads a scene; throws InputException if it is missing or none, SettingException if a value cannot be used. */
    public static Scene read(Path file) {
        return new Scenes(JsonObject.read(file), Optional.of(new OwnFolder(file.toAbsolutePath(), "scene"))).scene();
    }

    /** True for a scene, which may be invalid. */
    public static boolean isScene(Path file) {
        try {
            return file.toString().toLowerCase(Locale.ROOT).endsWith(".json")
                    && JsonObject.read(file).has("camera");
        } catch (InputException notJson) {
            return false;
        }
    }

    private Scene scene() {
        root.required(SceneSettings.MESH.fileKey(), "\"snake\"");
        root.required(SceneSettings.TEXTURE.fileKey(), "\"elaphe\"");
        Choices own = root.choices(SceneSettings.OF_ROOT);
        own = resolve(own, SceneSettings.MESH, BuiltInMeshes.names());
        own = resolve(own, SceneSettings.TEXTURE, BodyTexture.names());
        own = resolve(own, SceneSettings.ORIENTATION_MAP, List.of(Body.NONE));
        if (own.get(SceneSettings.INDEX).isByWavelength()) {
            own = resolve(own, SceneSettings.INDEX, index -> SkinIndex.of(resolve(index.file(), List.of())));
        }
        Optional<JsonObject> plan = root.findObject("plan");
        Choices methodChoices = plan.map(keys -> keys.choices(Methods.SETTINGS)).orElse(Choices.none());
        methodChoices =
                methodChoices.has(ILLUMINANT) ? resolve(methodChoices, ILLUMINANT, Illuminant.NAMES) : methodChoices;
        JsonObject weights = root.object("weights", "{ \"diffraction\": 20, \"texture\": 1 }");
        Scene scene = new Scene(
                own.over(weights.choices(SceneSettings.WEIGHTS)),
                patches(),
                view(root.object("camera", "{ \"position\": ... }")),
                orientation(),
                light(root.object("light", "{ \"direction\": [0, 0, 1] }")),
                root.objects("fillLights", Scene.MOST_FILL_LIGHTS).stream()
                        .map(Scenes::light)
                        .toList(),
                new SceneMethod(methodChoices));
        plan.ifPresent(JsonObject::requireNoOthers);
        weights.requireNoOthers();
        root.requireNoOthers();
        return scene;
    }

    private PatchAtlas patches() {
        JsonNode value = root.required("patch", "\"elaphe-like\"");
        if (!value.isObject() || !value.has(SceneSettings.PATCH_MAP.fileKey())) {
            return PatchAtlas.of(patch(root, "patch"));
        }
        JsonObject keys = root.object("patch", "");
        String map = resolve(keys.choices(List.of(SceneSettings.PATCH_MAP)), SceneSettings.PATCH_MAP, List.of())
                .get(SceneSettings.PATCH_MAP);
        List<PatchAtlas.Region> regions = new ArrayList<>();
        for (String key : keys.others()) {
            regions.add(new PatchAtlas.Region(keys.checked(key, () -> SceneColor.parse(key)), patch(keys, key)));
        }
        return root.checked("patch", () -> new PatchAtlas(map, regions));
    }

    /** A name, or an object with a name or file and further {@link PatchSettings}. */
    private PatchRequest patch(JsonObject object, String key) {
        JsonNode value = object.required(key, "\"elaphe-like\"");
        Choices choices;
        if (value.isTextual()) {
            choices = Choices.at(object.originAt(key)).with(PatchSettings.PATCH, value.textValue());
        } else {
            JsonObject keys = object.object(key, "");
            keys.required(PatchSettings.PATCH.fileKey(), "\"scan.png\"");
            choices = keys.choices(PatchSettings.ALL);
            keys.requireNoOthers();
        }
        return new PatchRequest(resolve(choices, PatchSettings.PATCH, BuiltInPatches.names()));
    }

    private Viewpoint view(JsonObject camera) {
        Vector3f position = place(camera, "position");
        Vector3f lookAt = place(camera, "lookAt");
        Vector3f up = camera.has("up") ? numbers(camera, "up") : new Vector3f(0, 0, 1);
        double angle = camera.choices(List.of(SceneSettings.FIELD_OF_VIEW)).get(SceneSettings.FIELD_OF_VIEW);
        Camera placed = root.checked("camera", () -> new Camera(position, lookAt, up));
        camera.requireNoOthers();
        return new Viewpoint(placed, angle);
    }

    /** Three lengths with units, to meters. */
    private static Vector3f place(JsonObject object, String key) {
        List<JsonNode> values = object.sequence(key, object.required(key, "[\"10 cm\", \"-20 cm\", \"15 cm\"]"), 3);
        return new Vector3f(floats(values, value -> object.quantity(key, value, Scenes::coordinate)));
    }

    private static double coordinate(String text) {
        double meters = Lengths.parse(text);
        if (!(Math.abs(meters) <= LARGEST_NUMBER)) {
            throw new IllegalArgumentException(Text.quoted(text) + " is out of range; give at most 1000 km");
        }
        return meters;
    }

    private static Vector3f numbers(JsonObject object, String key) {
        List<JsonNode> values = object.sequence(key, object.required(key, "[0, 0, 1]"), 3);
        return new Vector3f(floats(values, value -> object.number(key, value, -LARGEST_NUMBER, LARGEST_NUMBER)));
    }

    private static float[] floats(List<JsonNode> values, ToDoubleFunction<JsonNode> number) {
        return Floats.of(values.size(), i -> number.applyAsDouble(values.get(i)));
    }

    private static SceneLight light(JsonObject light) {
        Vector3f direction = numbers(light, "direction");
        Choices choices = light.choices(List.of(SceneSettings.INTENSITY, SceneSettings.ANGULAR_DIAMETER));
        SceneLight result = light.checked(
                "direction",
                () -> new SceneLight(
                        direction, choices.get(SceneSettings.INTENSITY), choices.get(SceneSettings.ANGULAR_DIAMETER)));
        light.requireNoOthers();
        return result;
    }

    private Quaternionfc orientation() {
        if (!root.has("orientation")) {
            return new Quaternionf();
        }
        List<JsonNode> values = root.sequence("orientation", root.required("orientation", "[0, 0, 0, 1]"), 4);
        float[] q = floats(values, number -> root.number("orientation", number, -1, 1));
        Quaternionf rotation = new Quaternionf(q[0], q[1], q[2], q[3]);
        if (Math.abs(rotation.lengthSquared() - 1) > 1e-3f) {
            throw root.complaint("orientation", "must be a unit quaternion x, y, z, w, such as [0, 0, 0, 1]");
        }
        return rotation;
    }

    /** Makes the file name of a setting absolute, unless it is a built-in name. */
    private Choices resolve(Choices choices, Setting<String> setting, List<String> builtIn) {
        return resolve(choices, setting, name -> resolve(name, builtIn));
    }

    private static <T> Choices resolve(Choices choices, Setting<T> setting, UnaryOperator<T> resolved) {
        try {
            return choices.with(setting, resolved.apply(choices.get(setting)), choices.origin(setting));
        } catch (IllegalArgumentException wrong) {
            throw choices.complaint(setting, wrong.getMessage());
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
                            : "is not one of " + String.join(", ", builtIn));
        }
        Path file = folder.get().file(name).normalize();
        if (!Files.exists(file)) {
            throw new IllegalArgumentException("is no file: there is no " + file + "; check the name"
                    + (builtIn.isEmpty() ? "" : ", or take one of " + String.join(", ", builtIn)));
        }
        folder.get().requireNoWayOut(file);
        return file.toString();
    }
}
