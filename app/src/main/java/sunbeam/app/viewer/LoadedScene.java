package sunbeam.app.viewer;

import java.util.List;
import java.util.Optional;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;

/**
 * A scene with its tables for final pictures and for previews.
 *
 * @param parts with the scene's own plan, of each part of the skin's light
 * @param coarse with {@link PreviewPlan}'s
 * @param mapped of a scene with tables of colours, with what they tabulate: for its BRDF maps
 */
record LoadedScene(List<SceneData> parts, SceneData coarse, Optional<SceneData> mapped) {

    /** Loads all, or what differs from the previous one. May take seconds. */
    static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous) {
        List<SceneData> parts = previous == null ? loader.parts(scene) : loader.parts(scene, previous.parts);
        SceneData fine = parts.get(0);
        Scene preview = coarse(scene, fine.patch());
        boolean kept = previous != null && previous.coarse.suits(preview);
        SceneData coarse = kept ? previous.coarse.with(preview) : loader.preview(preview, fine);
        Optional<SceneData> before = previous == null ? Optional.empty() : previous.mapped;
        Optional<SceneData> mapped = tabulated(scene, fine.patch())
                .map(full -> before.filter(data -> data.suits(full))
                        .map(data -> data.with(full))
                        .orElseGet(() -> loader.preview(full, fine)));
        return new LoadedScene(parts, coarse, mapped);
    }

    /** The scene with the method whose colours its own method tabulates, if it does. */
    private static Optional<Scene> tabulated(Scene scene, Patch patch) {
        return Optional.of(tabulated(scene.method().seeing(patch)))
                .filter(method -> scene.method().type() == TableMethod.TYPE)
                .map(scene::withMethod);
    }

    private static SceneMethod tabulated(SceneMethod method) {
        return method.type() == TableMethod.TYPE
                ? new SceneMethod(method.choices().with(Methods.METHOD, FullMethod.TYPE))
                : method;
    }

    /** What all parts share, and the first one's plan. */
    SceneData fine() {
        return parts.get(0);
    }

    /** Whether another scene needs no loading. */
    boolean suits(Scene scene) {
        return fine().suits(scene);
    }

    LoadedScene with(Scene scene) {
        return new LoadedScene(
                parts.stream().map(part -> part.with(scene)).toList(),
                coarse.with(coarse(scene, fine().patch())),
                mapped.map(data -> data.with(scene.withMethod(data.scene().method()))));
    }

    private static Scene coarse(Scene scene, Patch patch) {
        SceneMethod seen = tabulated(scene.method().seeing(patch));
        SceneMethod method = PreviewPlan.of(seen);
        double scale = PreviewPlan.radianceScale(seen, method);
        Blend blend = scene.blend();
        return scene.withMethod(method).withBlend(blend.withDiffraction(scale * blend.diffraction()));
    }
}
