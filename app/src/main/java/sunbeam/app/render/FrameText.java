package sunbeam.app.render;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import sunbeam.app.files.input.PngText;
import sunbeam.app.render.SceneData.ReflectanceComponent;
import sunbeam.app.render.SceneShape.Thing;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.files.Checksum;
import sunbeam.precompute.files.Sha256;

/** Text chunks of frames, with a hash that tells whether an existing file is up to date. */
public final class FrameText {
    private final List<SceneData> parts;
    private final String size;
    private final PixelSamples samples;
    private final String inputs;

    /**
     * @param parts data of the scene, one for each look, patch and reflectance component
     * @param overlays description of what is drawn over the picture; empty for nothing
     */
    public FrameText(List<SceneData> parts, int width, int height, PixelSamples samples, String overlays) {
        this.parts = List.copyOf(parts);
        this.size = width + "x" + height;
        this.samples = samples;
        Checksum things = new Checksum();
        for (Thing thing : parts.get(0).shape().things()) {
            Mesh mesh = thing.mesh();
            Body body = thing.body();
            things.add(thing.toModel().get(new float[16]))
                    .add(mesh.positions())
                    .add(mesh.normals())
                    .add(mesh.tangents())
                    .add(mesh.textureCoordinates())
                    .add(mesh.indices())
                    .add(body.colors().rgba())
                    .add(body.relief().rgba())
                    .add(body.directions().rgba())
                    .add(body.patches().rgba());
        }
        inputs = String.join(
                "|",
                Environment.version(),
                joined(data -> data.patch().heights().digest()),
                joined(data -> data.reflectanceComponent()
                        .map(ReflectanceComponent::digest)
                        .orElse("")),
                things.hex(),
                parts.get(0).shape().environment().map(RadianceMap::digest).orElse(""),
                size,
                samples.describe() + overlays);
    }

    private String joined(Function<SceneData, String> of) {
        return parts.stream().map(of).distinct().collect(Collectors.joining(", "));
    }

    /** Returns the hash of all that a frame of this scene depends on; frames with equal hashes are equal. */
    public String identity(Scene scene) {
        return Sha256.of(inputs + SceneWriter.describe(scene));
    }

    /** Returns a frame's text chunks; {@code renderer} is the driver's GL_RENDERER. */
    public Map<String, String> of(Scene scene, double exposure, String renderer) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", scene.get(SceneSettings.TITLE).isEmpty() ? "Scene" : scene.get(SceneSettings.TITLE));
        text.put("Scene", SceneWriter.caption(scene));
        text.put("Patch", joined(data -> data.patch().source()));
        text.put("Method", scene.method().method().type().label());
        text.put("Plan", parts.get(0).method().summary());
        text.put("Size", size + ", " + samples.describe());
        text.put("Exposure", Double.toString(exposure));
        text.put("Renderer", renderer);
        text.put(PngText.PARAMETERS, identity(scene));
        return text;
    }
}
