package sunbeam.app.viewer.model;

import java.util.List;
import java.util.function.DoubleConsumer;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.work.BackgroundTask;

/** Scene in memory, with a part for each look, each of its patches and each Fresnel component of the patch's reflection. */
public record LoadedScene(List<SceneData> parts) {

    /** May take seconds. */
    public static LoadedScene load(SceneLoader loader, Scene scene, BackgroundTask<SceneShape> shape) {
        return prepared(loader.parts(scene, shape));
    }

    /** Reuses equal parts of the previous scene, or null; reports the completed share, 0 to 1. May take seconds. */
    public static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous, DoubleConsumer progress) {
        if (previous == null) {
            return load(loader, scene, BackgroundTask.start(() -> loader.shape(scene)));
        }
        List<SceneData> parts = loader.parts(scene, previous.parts, progress);
        return previous.firstPart().suits(scene) ? new LoadedScene(parts) : prepared(parts);
    }

    /** Prepares the tables in the background, while the render thread uploads the parts. */
    private static LoadedScene prepared(List<SceneData> parts) {
        // An environment's lights are found here, so that the event thread does not wait for them.
        parts.get(0).lit();
        parts.get(0)
                .bakers()
                .ifPresent(levels -> BackgroundTask.start(() -> {
                    levels.prepare();
                    return levels;
                }));
        return new LoadedScene(parts);
    }

    /** All parts share its scene data. */
    public SceneData firstPart() {
        return parts.get(0);
    }

    public List<SceneData> ofPatch(int object, int region) {
        return parts.stream().filter(part -> part.draws(object, region)).toList();
    }

    /** Returns the same parts with a scene for which {@link SceneData#suits} holds. */
    public LoadedScene with(Scene scene) {
        return new LoadedScene(parts.stream().map(part -> part.with(scene)).toList());
    }
}
