package sunbeam.app.viewer;

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
 * @param fine with the scene's own plan
 * @param coarse with {@link PreviewPlan}'s
 * @param mapped of a scene with tables of colours, with what they tabulate: for its BRDF maps
 */
record LoadedScene(SceneData fine, SceneData coarse, Optional<SceneData> mapped) {

    /** Loads all, or what differs from the previous one. May take seconds. */
    static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous) {
        SceneData fine = previous == null ? loader.load(scene) : loader.load(scene, previous.fine);
        Scene preview = coarse(scene, fine.patch());
        boolean kept = previous != null && previous.coarse.suits(preview);
        SceneData coarse = kept ? previous.coarse.with(preview) : loader.preview(preview, fine);
        Optional<SceneData> before = previous == null ? Optional.empty() : previous.mapped;
        Optional<SceneData> mapped = tabulated(scene, fine.patch())
                .map(full -> before.filter(data -> data.suits(full))
                        .map(data -> data.with(full))
                        .orElseGet(() -> loader.preview(full, fine)));
        return new LoadedScene(fine, coarse, mapped);
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

    /** Whether another scene needs no loading. */
    boolean suits(Scene scene) {
        return fine.suits(scene);
    }

    LoadedScene with(Scene scene) {
        return new LoadedScene(
                fine.with(scene),
                coarse.with(coarse(scene, fine.patch())),
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
