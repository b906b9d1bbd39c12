package sunbeam.app.viewer;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.work.Meanwhile;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;

/**
 * A scene with its tables.
 *
 * @param parts of each part of the skin's light
 * @param map of a scene with tables of colors, with what they tabulate: for its BRDF map; empty until the second load
 */
record LoadedScene(List<SceneData> parts, Optional<SceneData> map) {

    /**
     * Loads all, or what differs from the previous one. May take seconds. What pictures of something new can do without is left
     * for the next load, so that the first one comes soon.
     *
     * @param previous null at first
     * @param progress told now and then the share that is done
     */
    static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous, DoubleConsumer progress) {
        List<SceneData> parts = previous == null ? loader.parts(scene) : loader.parts(scene, previous.parts, progress);
        LoadedScene loaded = new LoadedScene(parts, Optional.empty());
        SceneData fine = loaded.fine();
        if (previous == null || !previous.fine().suits(scene)) {
            // Long before anybody looks: what that needs is one processor's work, as is opening OpenGL.
            fine.levels()
                    .ifPresent(levels -> Meanwhile.start(() -> {
                        levels.prepare();
                        return levels;
                    }));
            return loaded;
        }
        if (loaded.isWhole()) {
            return loaded;
        }
        Scene tabulated = tabulated(fine.scene(), fine);
        SceneData map = previous.map
                .filter(data -> data.suits(tabulated))
                .map(data -> data.with(tabulated))
                .orElseGet(() -> loader.preview(tabulated, fine, progress));
        return new LoadedScene(parts, Optional.of(map));
    }

    /** The scene with the method whose colors its own method tabulates. */
    private static Scene tabulated(Scene scene, SceneData fine) {
        SceneMethod seen = scene.method().seeing(fine.patch());
        return scene.withMethod(new SceneMethod(seen.choices().with(Methods.METHOD, FullMethod.TYPE)));
    }

    /** What all parts share, and the first one's plan. */
    SceneData fine() {
        return parts.get(0);
    }

    /** Whether its colors are in tables. */
    boolean isByTable() {
        return fine().scene().method().type() == TableMethod.TYPE;
    }

    /** Whether nothing has been left for the next load: its BRDF map can be drawn. */
    boolean isWhole() {
        return !isByTable() || map.isPresent();
    }

    /** The same parts for another scene that they suit. */
    LoadedScene with(Scene scene) {
        return new LoadedScene(
                parts.stream().map(part -> part.with(scene)).toList(),
                map.map(data -> data.with(scene.withMethod(data.scene().method()))));
    }
}
