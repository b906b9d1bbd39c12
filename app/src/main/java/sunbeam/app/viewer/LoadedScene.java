package sunbeam.app.viewer;

import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.patch.Patch;

/**
 * A scene with its tables for final pictures and for previews.
 *
 * @param fine with the scene's own plan
 * @param coarse with {@link PreviewPlan}'s
 */
record LoadedScene(SceneData fine, SceneData coarse) {

    /** Loads all, or what differs from the previous one. May take seconds. */
    static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous) {
        SceneData fine = previous == null ? loader.load(scene) : loader.load(scene, previous.fine);
        Scene preview = coarse(scene, fine.patch());
        boolean kept = previous != null && previous.coarse.suits(preview);
        SceneData coarse = kept ? previous.coarse.with(preview) : loader.preview(preview, fine);
        return new LoadedScene(fine, coarse);
    }

    /** Whether another scene needs no loading. */
    boolean suits(Scene scene) {
        return fine.suits(scene);
    }

    LoadedScene with(Scene scene) {
        return new LoadedScene(fine.with(scene), coarse.with(coarse(scene, fine.patch())));
    }

    private static Scene coarse(Scene scene, Patch patch) {
        SceneMethod seen = scene.method().seeing(patch);
        SceneMethod method = PreviewPlan.of(seen);
        double scale = PreviewPlan.radianceScale(seen, method);
        Blend blend = scene.blend();
        return scene.withMethod(method).withBlend(blend.withDiffraction(scale * blend.diffraction()));
    }
}
