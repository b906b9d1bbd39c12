package sunbeam.app.viewer.model;

import java.util.List;
import java.util.function.DoubleConsumer;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.scene.Scene;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.method.TableMethod;

/**
 * Scene with mesh, heights and tables in memory.
 *
 * @param parts one element for each patch and each Fresnel component of the patch's reflection
 */
public record LoadedScene(List<SceneData> parts) {

    /**
     * Loads a scene, reusing equal parts of the previous one. May take seconds.
     *
     * @param previous previously loaded scene; null for the first
     * @param progress receives the completed share, 0 to 1
     */
    public static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous, DoubleConsumer progress) {
        List<SceneData> parts = previous == null ? loader.parts(scene) : loader.parts(scene, previous.parts, progress);
        LoadedScene loaded = new LoadedScene(parts);
        if (previous == null || !previous.firstPart().suits(scene)) {
            // Prepare the tables now: this uses one processor while OpenGL opens on the other.
            loaded.firstPart()
                    .bakers()
                    .ifPresent(levels -> BackgroundTask.start(() -> {
                        levels.prepare();
                        return levels;
                    }));
        }
        return loaded;
    }

    /** Returns the first part; all parts share its scene data. */
    public SceneData firstPart() {
        return parts.get(0);
    }

    /** Returns the parts of a patch, given its index in the scene. */
    public List<SceneData> ofRegion(int region) {
        return parts.stream().filter(part -> part.region() == region).toList();
    }

    /** True if the method is {@code table}. */
    public boolean isByTable() {
        return firstPart().scene().method().type().equals(TableMethod.TYPE);
    }

    /** Returns the same parts with another scene, for which {@link Scene#sharesParts} holds. */
    public LoadedScene with(Scene scene) {
        return new LoadedScene(parts.stream().map(part -> part.with(scene)).toList());
    }
}
