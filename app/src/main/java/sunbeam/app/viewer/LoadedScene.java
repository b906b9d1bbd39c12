package sunbeam.app.viewer;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.work.Meanwhile;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/**
 * A scene with its tables for final pictures and for previews.
 *
 * @param parts with the scene's own plan, of each part of the skin's light
 * @param coarse with {@link PreviewPlan}'s
 * @param moving with tables of colors, for pictures of what moves, where the scene's own method has none; the method
 *     must be one whose colors can be averaged over what a pixel sees
 * @param mapped of a scene with tables of colors, with what they tabulate: for its BRDF maps
 * @param isWhole whether nothing has been left for the next load
 */
record LoadedScene(
        List<SceneData> parts,
        SceneData coarse,
        Optional<SceneData> moving,
        Optional<SceneData> mapped,
        boolean isWhole) {

    // Without diffracted light any method will do: one that needs no tables.
    private static final SceneMethod BARE =
            new SceneMethod(Choices.none().with(Methods.METHOD, GemMethod.TYPE).with(MethodSettings.SPACING, 1e-6));

    /**
     * Loads all, or what differs from the previous one. May take seconds. What pictures of something new can do without is left
     * for the next load, so that the first one comes soon.
     */
    static LoadedScene load(SceneLoader loader, Scene scene, LoadedScene previous) {
        return load(loader, scene, previous, new Sparing(), share -> {});
    }

    /**
     * As {@link #load(SceneLoader, Scene, LoadedScene)}.
     *
     * @param sparing for what was left for this load, which waits while something moves
     * @param progress told now and then the share that is done
     */
    static LoadedScene load(
            SceneLoader loader, Scene scene, LoadedScene previous, Sparing sparing, DoubleConsumer progress) {
        List<SceneData> parts = previous == null ? loader.parts(scene) : loader.parts(scene, previous.parts, progress);
        SceneData fine = parts.get(0);
        Scene preview = coarse(scene, parts);
        boolean later =
                isLookedUp(parts) && (previous == null || !previous.fine().suits(scene));
        if (later) {
            // Long before anybody looks: what that needs is one processor's work, as is opening OpenGL.
            fine.levels()
                    .ifPresent(levels -> Meanwhile.start(() -> {
                        levels.prepare();
                        return levels;
                    }));
        }
        boolean kept = previous != null && previous.coarse.suits(preview);
        SceneData coarse = kept ? previous.coarse.with(preview) : loader.preview(preview, fine, share -> {});
        Optional<SceneData> moving = previous == null ? Optional.empty() : moving(loader, scene, fine, previous);
        Optional<SceneData> mapped = tabulated(scene, fine.patch())
                .filter(full -> !later)
                .map(full -> previous == null
                        ? other(loader, full, fine, Optional.empty())
                        // Something may move already.
                        : Sparing.call(() -> mapped(loader, full, fine, previous, sparing, progress)));
        return new LoadedScene(parts, coarse, moving, mapped, previous != null && !later);
    }

    /** For what was left for this load nobody waits. */
    private static SceneData mapped(
            SceneLoader loader,
            Scene full,
            SceneData fine,
            LoadedScene previous,
            Sparing sparing,
            DoubleConsumer progress) {
        if (previous.isWhole) {
            return other(loader, full, fine, previous.mapped);
        }
        sparing.pause();
        return loader.preview(full, fine, share -> {
            progress.accept(share);
            sparing.pause();
        });
    }

    /** Tables that cannot be had are done without: what moves is drawn in fewer pixels then, as the status line says. */
    private static Optional<SceneData> moving(SceneLoader loader, Scene scene, SceneData fine, LoadedScene previous) {
        try {
            return MovingPlan.of(scene, fine.patch()).map(table -> other(loader, table, fine, previous.moving));
        } catch (SettingException refused) {
            return Optional.empty();
        }
    }

    private static SceneData other(SceneLoader loader, Scene scene, SceneData fine, Optional<SceneData> before) {
        return before.filter(data -> data.suits(scene))
                .map(data -> data.with(scene))
                .orElseGet(() -> loader.preview(scene, fine, share -> {}));
    }

    /** The scene with the method whose colors its own method tabulates, if it does. */
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

    /** Whether what moves will be drawn by tables, once colors for that have been made. */
    boolean willMove() {
        return moving.isPresent() || (parts.size() == 1 && fine().levels().isPresent());
    }

    LoadedScene with(Scene scene) {
        return new LoadedScene(
                parts.stream().map(part -> part.with(scene)).toList(),
                coarse.with(coarse(scene, parts)),
                moving.map(data -> data.with(scene.withMethod(data.scene().method()))),
                mapped.map(data -> data.with(scene.withMethod(data.scene().method()))),
                isWhole);
    }

    /** Whether coarse colors come so soon that nothing else need be drawn by: those of an ensemble average have levels. */
    private static boolean isLookedUp(List<SceneData> parts) {
        return parts.size() == 1
                && parts.get(0)
                        .levels()
                        .filter(levels -> levels.levels().levels().size() > 1)
                        .isPresent();
    }

    /** Whether nothing but the body is drawn before there are colors. */
    boolean waitsForColors() {
        return isLookedUp(parts);
    }

    /** Whether a BRDF map can be drawn. */
    boolean hasMap() {
        return mapped.isPresent() || fine().levels().isEmpty();
    }

    private static Scene coarse(Scene scene, List<SceneData> parts) {
        if (isLookedUp(parts)) {
            return scene.withMethod(BARE).withBlend(scene.blend().withDiffraction(0));
        }
        SceneMethod seen = tabulated(scene.method().seeing(parts.get(0).patch()));
        SceneMethod method = PreviewPlan.of(seen);
        double scale = PreviewPlan.radianceScale(seen, method);
        Blend blend = scene.blend();
        return scene.withMethod(method).withBlend(blend.withDiffraction(scale * blend.diffraction()));
    }
}
