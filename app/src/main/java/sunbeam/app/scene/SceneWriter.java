package sunbeam.app.scene;

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
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.OutputException;
import sunbeam.app.output.Overwrite;
import sunbeam.precompute.units.Lengths;

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
        if (!scene.title().isEmpty()) {
            json.writeStringField("title", scene.title());
        }
        json.writeStringField("mesh", names.of(scene.mesh()));
        new ScenePlanWriter(json).patch(scene.patch(), names);
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
        json.writeNumberField("intensity", scene.light().intensity());
        json.writeEndObject();
        json.writeStringField("texture", names.of(scene.texture()));
        new ScenePlanWriter(json).plan(scene.method(), scene.plan());
        json.writeStringField("rotatePatch", SceneUnits.angleText(scene.rotatePatch()));
        if (scene.exposure().isPresent()) {
            json.writeNumberField("exposure", scene.exposure().getAsDouble());
        } else {
            json.writeStringField("exposure", "auto");
        }
        weights(scene.blend());
        json.writeStringField("background", scene.background().toString());
        json.writeEndObject();
    }

    private void camera(Viewpoint view) throws IOException {
        json.writeObjectFieldStart("camera");
        place("position", view.camera().centerOfProjection());
        place("lookAt", view.camera().lookAtPoint());
        direction("up", view.camera().up());
        json.writeStringField("fieldOfView", SceneUnits.angleText(view.verticalFieldOfView()));
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

    private void weights(Blend blend) throws IOException {
        json.writeObjectFieldStart("weights");
        json.writeNumberField("diffraction", blend.diffraction());
        json.writeNumberField("texture", blend.texture());
        json.writeNumberField("diffuse", blend.diffuse());
        json.writeNumberField("ambient", blend.ambient());
        json.writeEndObject();
    }

    /** For messages of the same form. */
    static String length(double metres) {
        String text = Lengths.format(metres);
        return Lengths.parse(text) == metres ? text : metres + " m";
    }
}
