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
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.JsonObject;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Finds built-in scenes and reads scene files (docs/scenes.md); messages name file, line and key. */
public final class Scenes {
    private static final List<String> NAMES =
            List.of(("close-up cabinet disc elaphe elaphe-body elaphe-scales xenopeltis"
                            + " xenopeltis-body xenopeltis-scales light-left light-above light-right")
                    .split(" ", -1));

    // Largest length, meters, and largest component of a direction.
    private static final double LARGEST_NUMBER = 1e6;
    // Smallest size, meters.
    private static final double SMALLEST_SIZE = 1e-9;

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
        Choices own = choices(root, SceneSettings.OF_ROOT);
        Optional<JsonObject> plan = root.findObject("plan");
        Choices methodChoices = plan.map(keys -> keys.choices(Methods.SETTINGS)).orElse(Choices.none());
        methodChoices =
                methodChoices.has(ILLUMINANT) ? resolve(methodChoices, ILLUMINANT, Illuminant.NAMES) : methodChoices;
        Viewpoint view = view(root.object("camera", "{ \"position\": ... }"));
        boolean hasObjects = root.has("objects");
        List<JsonObject> keys = hasObjects ? root.objects("objects", SceneObject.MOST) : List.of(root);
        if (keys.isEmpty()) {
            throw root.complaint("objects", "is empty; give 1 to " + SceneObject.MOST + " objects, or leave it out");
        }
        List<SceneObject> objects =
                keys.stream().map(object -> object(object, hasObjects)).toList();
        Choices environment = environment();
        boolean isLit = !environment.get(SceneSettings.ENVIRONMENT).equals(SceneSettings.NONE);
        Scene scene = new Scene(
                        own.over(environment),
                        objects.get(0).patches(),
                        view,
                        orientation(root),
                        isLit && !root.has("light")
                                ? new SceneLight(new Vector3f(0, 0, 1), 1, 0)
                                : light(root.object("light", "{ \"direction\": [0, 0, 1] }")),
                        root.objects("fillLights", Scene.MOST_FILL_LIGHTS).stream()
                                .map(Scenes::light)
                                .toList(),
                        new SceneMethod(methodChoices))
                .withObjects(objects);
        plan.ifPresent(JsonObject::requireNoOthers);
        root.requireNoOthers();
        return scene;
    }

    /** A name, or an object with a name or file and further settings. */
    private Choices environment() {
        if (!root.has("environment")) {
            return Choices.none();
        }
        JsonNode value = root.required("environment", "\"window\"");
        Choices choices;
        if (value.isTextual()) {
            choices = Choices.at(root.originAt("environment")).with(SceneSettings.ENVIRONMENT, value.textValue());
        } else {
            JsonObject keys = root.object("environment", "");
            keys.required(SceneSettings.ENVIRONMENT.fileKey(), "\"window\"");
            choices = keys.choices(SceneSettings.OF_ENVIRONMENT);
            keys.requireNoOthers();
        }
        return resolve(choices, SceneSettings.ENVIRONMENT, SceneSettings.environments());
    }

    /** Reads settings, with absolute names of files. */
    private Choices choices(JsonObject object, List<Setting<?>> settings) {
        Choices own = object.choices(settings);
        own = resolve(own, SceneSettings.MESH, BuiltInMeshes.names());
        own = resolve(own, SceneSettings.TEXTURE, BodyTexture.names());
        own = resolve(own, SceneSettings.ORIENTATION_MAP, List.of(Body.NONE));
        return own.has(SceneSettings.INDEX) && own.get(SceneSettings.INDEX).isByWavelength()
                ? resolve(own, SceneSettings.INDEX, index -> SkinIndex.of(resolve(index.file(), List.of())))
                : own;
    }

    /** Reads an object, which is the root or one of its list. An object of the list inherits missing keys from the root. */
    private SceneObject object(JsonObject keys, boolean isOfList) {
        Choices own =
                choices(keys, SceneSettings.OF_ROOT_OR_OBJECT).over(weights(keys, !isOfList || !root.has("weights")));
        Placement placement = Placement.NONE;
        if (isOfList) {
            Choices common = choices(root, SceneSettings.OF_ROOT_OR_OBJECT);
            common = own.has(SceneSettings.MESH) ? common.without(SceneSettings.MESH_UNIT) : common;
            own = own.over(common.over(root.has("weights") ? weights(root, true) : Choices.none()));
            placement = placement(keys);
        }
        holder(keys, SceneSettings.MESH.fileKey()).required(SceneSettings.MESH.fileKey(), "\"snake\"");
        holder(keys, SceneSettings.TEXTURE.fileKey()).required(SceneSettings.TEXTURE.fileKey(), "\"elaphe\"");
        PatchAtlas patches = patches(holder(keys, "patch"));
        if (isOfList) {
            keys.requireNoOthers();
        }
        return new SceneObject(own, patches, placement);
    }

    /** Returns the root if an object of its list leaves a key to it. */
    private JsonObject holder(JsonObject object, String key) {
        return !object.has(key) && root.has(key) ? root : object;
    }

    private static Choices weights(JsonObject object, boolean isRequired) {
        if (!isRequired && !object.has("weights")) {
            return Choices.none();
        }
        JsonObject weights = object.object("weights", "{ \"diffraction\": 20, \"texture\": 1 }");
        Choices choices = weights.choices(SceneSettings.WEIGHTS);
        weights.requireNoOthers();
        return choices;
    }

    private static Placement placement(JsonObject object) {
        Vector3f position = object.has("position") ? place(object, "position") : new Vector3f();
        OptionalDouble size = OptionalDouble.empty();
        if (object.has("size")) {
            size = OptionalDouble.of(object.quantity("size", object.required("size", ""), Scenes::size));
        }
        return new Placement(position, orientation(object), size);
    }

    private static double size(String text) {
        double meters = coordinate(text);
        if (!(meters >= SMALLEST_SIZE)) {
            throw new IllegalArgumentException(Text.quoted(text) + " is out of range; give 1 nm to 1e6 m");
        }
        return meters;
    }

    private PatchAtlas patches(JsonObject object) {
        JsonNode value = object.required("patch", "\"elaphe-like\"");
        if (!value.isObject() || !value.has(SceneSettings.PATCH_MAP.fileKey())) {
            return PatchAtlas.of(patch(object, "patch"));
        }
        JsonObject keys = object.object("patch", "");
        String map = resolve(keys.choices(List.of(SceneSettings.PATCH_MAP)), SceneSettings.PATCH_MAP, List.of())
                .get(SceneSettings.PATCH_MAP);
        List<PatchAtlas.Region> regions = new ArrayList<>();
        for (String key : keys.others()) {
            regions.add(new PatchAtlas.Region(keys.checked(key, () -> SceneColor.parse(key)), patch(keys, key)));
        }
        return object.checked("patch", () -> new PatchAtlas(map, regions));
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
            throw new IllegalArgumentException(Text.quoted(text) + " is out of range; give at most 1e6 m");
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

    private static Quaternionfc orientation(JsonObject object) {
        if (!object.has("orientation")) {
            return new Quaternionf();
        }
        List<JsonNode> values = object.sequence("orientation", object.required("orientation", "[0, 0, 0, 1]"), 4);
        float[] q = floats(values, number -> object.number("orientation", number, -1, 1));
        Quaternionf rotation = new Quaternionf(q[0], q[1], q[2], q[3]);
        if (Math.abs(rotation.lengthSquared() - 1) > 1e-3f) {
            throw object.complaint("orientation", "must be a unit quaternion x, y, z, w, such as [0, 0, 0, 1]");
        }
        return rotation;
    }

    /** Makes the file name of a setting absolute, unless it is a built-in name. */
    private Choices resolve(Choices choices, Setting<String> setting, List<String> builtIn) {
        return resolve(choices, setting, name -> resolve(name, builtIn));
    }

    private static <T> Choices resolve(Choices choices, Setting<T> setting, UnaryOperator<T> resolved) {
        if (!choices.has(setting)) {
            return choices;
        }
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
