package sunbeam.app.scene;

import static sunbeam.precompute.plan.MethodSettings.ILLUMINANT;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3fc;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StreamContent;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.JsonObject;
import sunbeam.precompute.setting.Setting;

/** Writes scene files that {@link Scenes} reads. */
public final class SceneWriter {
    private static final List<Setting<?>> OMITTED_IF_STANDARD =
            List.of(SceneSettings.TITLE, SceneSettings.MESH_UNIT, SceneSettings.INDEX);

    private final JsonGenerator json;
    private final UnaryOperator<String> toWrittenName;

    private SceneWriter(JsonGenerator json, UnaryOperator<String> toWrittenName) {
        this.json = json;
        this.toWrittenName = toWrittenName;
    }

    /**
     * Writes atomically; named files must be in the target's folder or below, and become relative to it.
     *
     * @throws OutputException if the file cannot be written, or a named file is elsewhere
     */
    public static void write(Path target, Overwrite overwrite, Scene scene) {
        Path folder = target.toAbsolutePath().normalize().getParent();
        String text = text(scene, scene.method().chosen(), name -> relative(folder, name)) + "\n";
        AtomicFile.write(target, overwrite, StreamContent.of(text));
    }

    /** Returns JSON with absolute file names; equal for equal scenes. */
    public static String describe(Scene scene) {
        return text(scene, scene.method().choices(), name -> name);
    }

    /** Returns JSON for a picture's metadata, without local folders. */
    public static String caption(Scene scene) {
        return text(
                scene,
                scene.method().choices(),
                name -> String.valueOf(Path.of(name).getFileName()));
    }

    private static String relative(Path folder, String name) {
        Path path = Path.of(name);
        if (!path.isAbsolute()) {
            return name;
        }
        if (!path.normalize().startsWith(folder)) {
            throw new OutputException("the scene uses " + path + ", which is not in the scene's folder " + folder
                    + "; copy it there and load it from there first");
        }
        return folder.relativize(path.normalize()).toString();
    }

    private static String text(Scene scene, Choices plan, UnaryOperator<String> toWrittenName) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
            json.setPrettyPrinter(new DefaultPrettyPrinter());
            new SceneWriter(json, toWrittenName).write(scene, plan);
        } catch (IOException failure) {
            throw new UncheckedIOException("a text in memory cannot be written", failure);
        }
        return text.toString();
    }

    private void write(Scene scene, Choices plan) throws IOException {
        json.writeStartObject();
        boolean isOne = scene.objects().size() == 1 && scene.placement().equals(Placement.NONE);
        settings(scene, isOne ? SceneSettings.OF_ROOT : SceneSettings.OF_ROOT_ALONE);
        if (isOne) {
            patches(scene.patches());
        }
        camera(scene.view());
        orientation(scene.orientation());
        if (scene.hasEnvironment()) {
            String name = toWrittenName.apply(scene.get(SceneSettings.ENVIRONMENT));
            Choices given = scene.settings().only(SceneSettings.OF_ENVIRONMENT).with(SceneSettings.ENVIRONMENT, name);
            boolean isAutomatic = scene.get(SceneSettings.ENVIRONMENT_LIGHTS).isEmpty();
            object("environment", isAutomatic ? given.without(SceneSettings.ENVIRONMENT_LIGHTS) : given);
        }
        json.writeFieldName("light");
        light(scene.light());
        if (!scene.fillLights().isEmpty()) {
            json.writeArrayFieldStart("fillLights");
            for (SceneLight light : scene.fillLights()) {
                light(light);
            }
            json.writeEndArray();
        }
        object("plan", plan.has(ILLUMINANT) ? plan.with(ILLUMINANT, toWrittenName.apply(plan.get(ILLUMINANT))) : plan);
        if (isOne) {
            object("weights", scene.weights());
        } else {
            json.writeArrayFieldStart("objects");
            for (Scene one : scene.perObject()) {
                thing(one);
            }
            json.writeEndArray();
        }
        json.writeEndObject();
    }

    /** Writes the current object of a scene. */
    private void thing(Scene scene) throws IOException {
        json.writeStartObject();
        settings(scene, SceneSettings.OF_ROOT_OR_OBJECT);
        patches(scene.patches());
        Placement placement = scene.placement();
        if (!placement.position().equals(0, 0, 0)) {
            place("position", placement.position());
        }
        orientation(placement.orientation());
        if (placement.size().isPresent()) {
            json.writeStringField("size", placement.size().getAsDouble() + " m");
        }
        object("weights", scene.weights());
        json.writeEndObject();
    }

    private void settings(Scene scene, List<Setting<?>> settings) throws IOException {
        Choices own = scene.settings();
        for (Setting<String> name : List.of(SceneSettings.MESH, SceneSettings.TEXTURE, SceneSettings.ORIENTATION_MAP)) {
            own = own.with(name, toWrittenName.apply(own.get(name)));
        }
        SkinIndex index = scene.get(SceneSettings.INDEX);
        own = index.isByWavelength()
                ? own.with(SceneSettings.INDEX, SkinIndex.of(toWrittenName.apply(index.file())))
                : own;
        for (Setting<?> setting : settings) {
            if (!OMITTED_IF_STANDARD.contains(setting) || !own.find(setting).equals(setting.standard())) {
                JsonObject.write(json, own.only(List.of(setting)));
            }
        }
    }

    private void patches(PatchAtlas patches) throws IOException {
        if (patches.isOne()) {
            patch("patch", patches.regions().get(0).patch());
            return;
        }
        json.writeObjectFieldStart("patch");
        JsonObject.write(json, Choices.none().with(SceneSettings.PATCH_MAP, toWrittenName.apply(patches.map())));
        for (PatchAtlas.Region region : patches.regions()) {
            patch(region.color().toString(), region.patch());
        }
        json.writeEndObject();
    }

    private void orientation(Quaternionfc turn) throws IOException {
        if (!turn.equals(new Quaternionf())) {
            json.writeFieldName("orientation");
            json.writeArray(new double[] {turn.x(), turn.y(), turn.z(), turn.w()}, 0, 4);
        }
    }

    private void light(SceneLight light) throws IOException {
        json.writeStartObject();
        direction("direction", light.towards());
        Choices choices = Choices.none().with(SceneSettings.INTENSITY, light.intensity());
        if (light.angularDiameter() > 0) {
            choices = choices.with(SceneSettings.ANGULAR_DIAMETER, light.angularDiameter());
        }
        JsonObject.write(json, choices);
        json.writeEndObject();
    }

    private void object(String key, Choices choices) throws IOException {
        json.writeObjectFieldStart(key);
        JsonObject.write(json, choices);
        json.writeEndObject();
    }

    private void patch(String key, PatchRequest patch) throws IOException {
        String file = toWrittenName.apply(patch.patch());
        if (patch.choices().without(PatchSettings.PATCH).chosen().isEmpty()) {
            json.writeStringField(key, file);
        } else {
            object(key, patch.choices().with(PatchSettings.PATCH, file));
        }
    }

    private void camera(Viewpoint view) throws IOException {
        json.writeObjectFieldStart("camera");
        place("position", view.camera().centerOfProjection());
        place("lookAt", view.camera().lookAtPoint());
        direction("up", view.camera().up());
        JsonObject.write(json, Choices.none().with(SceneSettings.FIELD_OF_VIEW, view.verticalFieldOfView()));
        json.writeEndObject();
    }

    /** Writes lengths with the fewest digits that read back as the same float, without a trailing ".0". */
    private void place(String key, Vector3fc value) throws IOException {
        json.writeArrayFieldStart(key);
        for (int axis = 0; axis < 3; axis++) {
            json.writeString(Float.toString(value.get(axis)).replaceFirst("\\.0$", "") + " m");
        }
        json.writeEndArray();
    }

    /** Writes the fewest digits that read back as the same float. */
    private void direction(String key, Vector3fc value) throws IOException {
        json.writeArrayFieldStart(key);
        for (int axis = 0; axis < 3; axis++) {
            json.writeNumber(value.get(axis));
        }
        json.writeEndArray();
    }
}
