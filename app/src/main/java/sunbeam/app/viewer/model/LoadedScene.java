package sunbeam.app.viewer.model;

import java.util.List;
import java.util.function.DoubleConsumer;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.method.TableMethod;

/**
 * A scene with its tables.
 *
 * @param parts of each patch and each part of its light
 */
public record LoadedScene(List<SceneData> parts) {

    /**
     * Loads all, or what differs from the previous one. May take seconds.
     *
     * @param previous null at first
     * @param progress told now and then the share that is done
     */
    public static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous, DoubleConsumer progress) {
        List<SceneData> parts = previous == null ? loader.parts(scene) : loader.parts(scene, previous.parts, progress);
        LoadedScene loaded = new LoadedScene(parts);
        if (previous == null || !previous.fine().suits(scene)) {
            // Long before anybody looks: what that needs is one processor's work, as is opening OpenGL.
            loaded.fine()
                    .levels()
                    .ifPresent(levels -> BackgroundTask.start(() -> {
                        levels.prepare();
                        return levels;
                    }));
        }
        return loaded;
    }

    /** What all parts share, and the first one's plan. */
    public SceneData fine() {
        return parts.get(0);
    }

    /** The parts of one patch, by its number among the scene's. */
    public List<SceneData> ofRegion(int region) {
        return parts.stream().filter(part -> part.region() == region).toList();
    }

    /** Whether its colors are in tables. */
    public boolean isByTable() {
        return fine().scene().method().type().equals(TableMethod.TYPE);
    }

    /** The same parts for another scene that they suit. */
    public LoadedScene with(Scene scene) {
        return new LoadedScene(parts.stream().map(part -> part.with(scene)).toList());
    }
}
