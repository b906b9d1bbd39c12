package sunbeam.app.scene;

import static sunbeam.app.scene.SceneSettings.BACKGROUND;
import static sunbeam.app.scene.SceneSettings.EXPOSURE;
import static sunbeam.app.scene.SceneSettings.FIELD_OF_VIEW;
import static sunbeam.app.scene.SceneSettings.INDEX;
import static sunbeam.app.scene.SceneSettings.INTENSITY;
import static sunbeam.app.scene.SceneSettings.MESH;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.app.scene.SceneSettings.TEXTURE;
import static sunbeam.app.scene.SceneSettings.TITLE;
import static sunbeam.app.scene.SceneSettings.TONE;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.joml.Quaternionf;
import org.joml.Vector3fc;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.json.JsonChoices;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.setting.Choices;

/** Writes scene files that {@link SceneReader} reads. */
public final class SceneWriter {
    private final JsonGenerator json;
    private final SceneNames names;

    private SceneWriter(JsonGenerator json, SceneNames names) {
        this.json = json;
        this.names = names;
    }

    /**
     * Writes a scene file, whole or not at all. Files that the scene names must lie in the target's folder or below; they
     * are written relative to it.
     *
     * @throws OutputException when the file cannot be written, or a file lies elsewhere
     */
    public static void write(Path target, Overwrite overwrite, Scene scene) {
        String text = text(scene, SceneNames.relativeTo(target)) + "\n";
        AtomicFile.write(target, overwrite, stream -> stream.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    /** The scene as JSON with absolute file names: equal texts for equal scenes. */
    public static String describe(Scene scene) {
        return text(scene, SceneNames.absolute());
    }

    /** The scene as JSON for whoever has a picture of it: without the folders of this machine. */
    public static String caption(Scene scene) {
        return text(scene, SceneNames.withoutFolders());
    }

    private static String text(Scene scene, SceneNames names) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
            json.setPrettyPrinter(new DefaultPrettyPrinter());
            new SceneWriter(json, names).write(scene);
        } catch (IOException failure) {
            throw new UncheckedIOException("a text in memory cannot be written", failure);
        }
        return text.toString();
    }

    private void write(Scene scene) throws IOException {
        json.writeStartObject();
        Choices title =
                scene.title().isEmpty() ? Choices.none() : Choices.none().with(TITLE, scene.title());
        JsonChoices.write(json, title.with(MESH, names.of(scene.mesh())));
        patch(scene.patch());
        camera(scene.view());
        if (!scene.orientation().equals(new Quaternionf())) {
            json.writeFieldName("orientation");
            json.writeArray(
                    new double[] {
                        scene.orientation().x(),
                        scene.orientation().y(),
                        scene.orientation().z(),
                        scene.orientation().w()
                    },
                    0,
                    4);
        }
        json.writeObjectFieldStart("light");
        direction("direction", scene.light().towards());
        JsonChoices.write(json, Choices.none().with(INTENSITY, scene.light().intensity()));
        json.writeEndObject();
        JsonChoices.write(json, Choices.none().with(TEXTURE, names.of(scene.texture())));
        object("plan", scene.method().choices());
        JsonChoices.write(
                json, Choices.none().with(ROTATE_PATCH, scene.rotatePatch()).with(EXPOSURE, scene.exposure()));
        if (scene.tone().isPresent()) {
            JsonChoices.write(json, Choices.none().with(TONE, scene.tone().get()));
        }
        object("weights", scene.blend().choices());
        SkinIndex index = scene.index();
        if (!index.equals(SkinIndex.KERATIN)) {
            JsonChoices.write(
                    json,
                    Choices.none().with(INDEX, index.isByWavelength() ? SkinIndex.of(names.of(index.file())) : index));
        }
        JsonChoices.write(json, Choices.none().with(BACKGROUND, scene.background()));
        json.writeEndObject();
    }

    private void object(String key, Choices choices) throws IOException {
        json.writeObjectFieldStart(key);
        JsonChoices.write(json, choices);
        json.writeEndObject();
    }

    private void patch(PatchRequest patch) throws IOException {
        String file = names.of(patch.patch());
        if (patch.isNameOnly()) {
            json.writeStringField("patch", file);
        } else {
            object("patch", patch.choices().with(PatchSettings.PATCH, file));
        }
    }

    private void camera(Viewpoint view) throws IOException {
        json.writeObjectFieldStart("camera");
        place("position", view.camera().centerOfProjection());
        place("lookAt", view.camera().lookAtPoint());
        direction("up", view.camera().up());
        JsonChoices.write(json, Choices.none().with(FIELD_OF_VIEW, view.verticalFieldOfView()));
        json.writeEndObject();
    }

    private void place(String key, Vector3fc value) throws IOException {
        json.writeFieldName(key);
        String[] coordinates = {
            SceneUnits.coordinateText(value.x()),
            SceneUnits.coordinateText(value.y()),
            SceneUnits.coordinateText(value.z())
        };
        json.writeArray(coordinates, 0, 3);
    }

    /** Floats with their own digits. */
    private void direction(String key, Vector3fc value) throws IOException {
        json.writeArrayFieldStart(key);
        json.writeNumber(value.x());
        json.writeNumber(value.y());
        json.writeNumber(value.z());
        json.writeEndArray();
    }
}
