package sunbeam.app.commands.render;

import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.app.gpu.picture.PictureParameters;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.SkinPart;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.files.Sha256;

/**
 * What a picture says of itself in its text chunks, with a hash of all that determines it: that tells whether a picture that is
 * there is the one that would be drawn.
 */
public final class FrameText {
    private final SceneData data;
    private final PictureSize size;
    private final int supersample;
    private final String inputs;

    /**
     * Of pictures of some data.
     *
     * @param data what the frames' scenes share
     * @param supersample samples along a pixel's side
     * @param overlays that are drawn over them, for people
     */
    public FrameText(SceneData data, PictureSize size, int supersample, String overlays) {
        this.data = data;
        this.size = size;
        this.supersample = supersample;
        Mesh mesh = data.mesh();
        String meshAndBody = new Sha256()
                .add(mesh.positions())
                .add(mesh.normals())
                .add(mesh.tangents())
                .add(mesh.textureCoordinates())
                .add(mesh.indices())
                .add(data.body().colors().rgba())
                .add(data.body().relief().rgba())
                .add(data.body().directions().rgba())
                .hex();
        inputs = String.join(
                "|",
                Version.number(),
                data.patch().digest(),
                data.part().map(SkinPart::digest).orElse(""),
                meshAndBody,
                size.toString(),
                "supersample " + supersample + overlays);
    }

    /** The hash of one frame. */
    String identity(Scene scene) {
        return Sha256.of(inputs + SceneWriter.describe(scene));
    }

    /**
     * Of one frame.
     *
     * @param exposure factor that the linear colors were multiplied by
     * @param renderer who drew, GL_RENDERER
     */
    public Map<String, String> of(Scene scene, double exposure, String renderer) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", scene.title().isEmpty() ? "Scene" : scene.title());
        text.put("Scene", SceneWriter.caption(scene));
        text.put("Patch", data.patch().source());
        text.put("Method", scene.method().method().type().label());
        text.put("Plan", data.method().summary());
        text.put("Size", size + ", " + supersample * supersample + " samples per pixel");
        text.put("Exposure", Double.toString(exposure));
        text.put("Renderer", renderer);
        text.put(PictureParameters.KEYWORD, identity(scene));
        return text;
    }
}
