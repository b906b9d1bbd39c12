package sunbeam.app.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import jrtr.scene.Camera;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import sunbeam.app.input.InputException;
import sunbeam.app.json.JsonFile;
import sunbeam.app.json.JsonObject;
import sunbeam.app.json.JsonValue;
import sunbeam.app.mesh.BuiltInMeshes;
import sunbeam.app.setup.MethodRequest;
import sunbeam.app.texture.BodyTextures;

/** Reads scene files (docs/scenes.md): strict, with messages that name file, line and key. */
public final class SceneReader {
    private static final double LARGEST_EXPOSURE = 1e9;
    private static final double STANDARD_FIELD_OF_VIEW = Math.toRadians(30);

    private final JsonObject root;
    private final SceneFolder folder;

    private SceneReader(JsonObject root, SceneFolder folder) {
        this.root = root;
        this.folder = folder;
    }

    /**
     * Reads a file. The files that it names must lie in its folder or below.
     *
     * @throws InputException when it is missing or not a scene
     */
    public static Scene read(Path file) {
        return new SceneReader(JsonFile.read(file), SceneFolder.of(file)).scene();
    }

    /** Whether a file is written as a scene is; it may still be a broken one. */
    public static boolean isScene(Path file) {
        try {
            return file.toString().toLowerCase(Locale.ROOT).endsWith(".json")
                    && JsonFile.read(file).has("camera");
        } catch (InputException notJson) {
            return false;
        }
    }

    /** Reads a scene that comes with Sunbeam and names no files. */
    static Scene readBuiltIn(String name, InputStream stream) throws IOException {
        return new SceneReader(JsonFile.read(name, stream), SceneFolder.none()).scene();
    }

    private Scene scene() {
        Optional<JsonObject> plan = root.findObject("plan");
        MethodRequest method = SceneMethodReader.read(plan);
        Scene scene = new Scene(
                root.text("title").orElse(""),
                source("mesh", "\"snake\"", BuiltInMeshes.names()),
                new ScenePatchReader(root, folder).read(),
                view(root.object("camera", "{ \"position\": ... }")),
                orientation(),
                light(root.object("light", "{ \"direction\": [0, 0, 1] }")),
                source("texture", "\"elaphe\"", BodyTextures.names()),
                method,
                ScenePlanReader.read(plan, method.kind()),
                root.parsed("rotatePatch", SceneUnits::angle).orElse(0.0),
                exposure(),
                blend(root.object("weights", "{ \"diffraction\": 20, \"texture\": 1 }")),
                root.parsed("background", SceneColor::parse).orElse(new SceneColor(0)),
                SceneOrigin.of(root));
        root.requireNoOthers();
        return scene;
    }

    private String source(String key, String example, List<String> builtIn) {
        return root.parsed(key, root.required(key, example), name -> folder.resolve(name, builtIn));
    }

    private static Viewpoint view(JsonObject camera) {
        Vector3f position = place(camera, "position");
        Vector3f lookAt = place(camera, "lookAt");
        Vector3f up = camera.has("up") ? numbers(camera, "up") : new Vector3f(0, 0, 1);
        double angle = camera.parsed("fieldOfView", SceneUnits::angle).orElse(STANDARD_FIELD_OF_VIEW);
        Camera placed = camera.checked("position", () -> new Camera(position, lookAt, up));
        Viewpoint view = camera.checked("fieldOfView", () -> new Viewpoint(placed, angle));
        camera.requireNoOthers();
        return view;
    }

    private static Vector3f place(JsonObject object, String key) {
        List<JsonValue> values = object.sequence(key, object.required(key, "[\"10 cm\", \"-20 cm\", \"15 cm\"]"), 3);
        float[] metres = new float[3];
        for (int i = 0; i < 3; i++) {
            double coordinate = object.parsed(key, values.get(i), SceneUnits::coordinate);
            metres[i] = (float) coordinate;
        }
        return new Vector3f(metres);
    }

    private static Vector3f numbers(JsonObject object, String key) {
        List<JsonValue> values = object.sequence(key, object.required(key, "[0, 0, 1]"), 3);
        float[] numbers = new float[3];
        for (int i = 0; i < 3; i++) {
            numbers[i] = (float) object.number(key, values.get(i), -1e6, 1e6);
        }
        return new Vector3f(numbers);
    }

    private static SceneLight light(JsonObject light) {
        Vector3f direction = numbers(light, "direction");
        double intensity = light.number("intensity", 0, 1e6).orElse(1);
        SceneLight result = light.checked("direction", () -> new SceneLight(direction, intensity));
        light.requireNoOthers();
        return result;
    }

    private Quaternionfc orientation() {
        if (!root.has("orientation")) {
            return new Quaternionf();
        }
        JsonValue value = root.required("orientation", "[0, 0, 0, 1]");
        List<JsonValue> values = root.sequence("orientation", value, 4);
        float[] q = new float[4];
        for (int i = 0; i < 4; i++) {
            q[i] = (float) root.number("orientation", values.get(i), -1, 1);
        }
        Quaternionf rotation = new Quaternionf(q[0], q[1], q[2], q[3]);
        if (Math.abs(rotation.lengthSquared() - 1) > 1e-3f) {
            throw root.complaint("orientation", value, "must be a unit quaternion x, y, z, w, such as [0, 0, 0, 1]");
        }
        return rotation;
    }

    private OptionalDouble exposure() {
        JsonValue value = root.find("exposure").orElse(new JsonValue.Text("auto", 0));
        if (value instanceof JsonValue.Text text) {
            if (text.text().equals("auto")) {
                return OptionalDouble.empty();
            }
            throw root.complaint("exposure", value, "must be \"auto\" or a number above 0 without quotes");
        }
        double factor = root.number("exposure", value, 0, LARGEST_EXPOSURE);
        if (factor < Double.MIN_NORMAL) {
            throw root.complaint("exposure", value, "must be above 0");
        }
        return OptionalDouble.of(factor);
    }

    private static Blend blend(JsonObject weights) {
        Blend blend = new Blend(
                weight(weights, "diffraction", 1),
                weight(weights, "texture", 1),
                weight(weights, "diffuse", 1),
                weight(weights, "ambient", 0));
        weights.requireNoOthers();
        return blend;
    }

    private static double weight(JsonObject weights, String key, double otherwise) {
        return weights.number(key, 0, Blend.LARGEST).orElse(otherwise);
    }
}
