package sunbeam.app.viewer;

import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
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
        requirePreviews(scene);
        SceneData fine = previous == null ? loader.load(scene) : loader.load(scene, previous.fine);
        Scene preview = coarse(scene, fine.patch());
        boolean kept = previous != null && previous.coarse.suits(preview);
        SceneData coarse = kept ? previous.coarse.with(preview) : loader.preview(preview, fine);
        return new LoadedScene(fine, coarse);
    }

    /**
     * Tables of colours are made as a picture's pixels look into them, which takes too long for one that moves.
     *
     * @throws sunbeam.precompute.setting.SettingException in the words of the place where the method was chosen
     */
    static void requirePreviews(Scene scene) {
        if (!hasPreviews(scene.method().type())) {
            throw scene.method()
                    .choices()
                    .complaint(
                            Methods.METHOD,
                            "is for pictures without a window; for the viewer use full, nmm, pq or gem");
        }
    }

    /** Whether the viewer draws with a method. */
    static boolean hasPreviews(MethodType type) {
        return SceneMethod.draws(type) && type != TableMethod.TYPE;
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
