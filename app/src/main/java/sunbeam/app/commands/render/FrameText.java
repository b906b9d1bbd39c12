package sunbeam.app.commands.render;

import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneWriter;

/** What a picture says of itself in its text chunks. */
public final class FrameText {
    private FrameText() {}

    /**
     * Of a picture of the loaded scene.
     *
     * @param supersample samples along a pixel's side
     * @param exposure factor that the linear colors were multiplied by
     * @param renderer who drew, GL_RENDERER
     */
    public static Map<String, String> of(
            SceneData data, PictureSize size, int supersample, double exposure, String renderer) {
        String identity = new FrameIdentity(data, size, supersample).of(data.scene());
        return of(data, data.scene(), size, supersample, exposure, renderer, identity);
    }

    static Map<String, String> of(
            SceneData data,
            Scene scene,
            PictureSize size,
            int supersample,
            double exposure,
            String renderer,
            String identity) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", scene.title().isEmpty() ? "Scene" : scene.title());
        text.put("Scene", SceneWriter.caption(scene));
        text.put("Patch", data.patch().source());
        text.put("Method", scene.method().method().type().label());
        text.put("Plan", data.method().summary());
        text.put("Size", size + ", " + supersample * supersample + " samples per pixel");
        text.put("Exposure", Double.toString(exposure));
        text.put("Renderer", renderer);
        text.put(FrameIdentity.KEYWORD, identity);
        return text;
    }
}
