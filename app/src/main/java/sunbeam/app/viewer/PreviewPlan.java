package sunbeam.app.viewer;

import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.util.List;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.setting.Choices;

/**
 * The method of moving pictures: the same surface, planned for what keeps the colors (the sources of error that the
 * tolerance bounds stay well below it, and below what the low resolution hides), and a coherence length of half the
 * scene's, which needs half the wavelengths. It blurs colors by no more than a preview's pixels do.
 */
final class PreviewPlan {
    private static final double TOLERANCE_OF_PREVIEWS = 0.4;
    // Shorter ones blur colors by more than 2 degrees: as wide as a preview's pixel on a curved skin, and seen.
    private static final double SHORTEST_COHERENCE_LENGTH = 20e-6;
    // Of pq, whose planned step is that of its sharp fringes: hundreds of wavelengths for a scan. Metres.
    private static final double REPLICAS_STEP = 20e-9;

    private PreviewPlan() {}

    static SceneMethod of(SceneMethod scene) {
        Choices choices = scene.choices().without(List.of(EXPANSION, TERMS, RADIUS, ANCHOR, WAVELENGTH_STEP));
        // With the thesis's preset nmm weighs no orders: another picture, not a finer one.
        if (!(scene.isThesis() && scene.type() == NmmMethod.TYPE)) {
            choices = choices.without(PRESET)
                    .with(TOLERANCE, Math.max(TOLERANCE_OF_PREVIEWS, scene.get(TOLERANCE)))
                    .with(WINDOW_ORIGIN, scene.area().origin());
        }
        if (scene.type() == PqMethod.TYPE) {
            choices = choices.with(WAVELENGTH_STEP, REPLICAS_STEP);
        }
        return new SceneMethod(
                scene.type() == FullMethod.TYPE ? choices.with(COHERENCE_LENGTH, shorter(scene)) : choices);
    }

    private static double shorter(SceneMethod scene) {
        double length = scene.get(COHERENCE_LENGTH);
        return Math.min(length, Math.max(length / 2, SHORTEST_COHERENCE_LENGTH));
    }

    /**
     * Factor of the relative radiance that keeps the BRDF where the window is another one: the mirror to which radiance
     * relates grows with the window's area (design, section 3).
     */
    static double radianceScale(SceneMethod scene, SceneMethod preview) {
        double ratio = preview.get(COHERENCE_LENGTH) / scene.get(COHERENCE_LENGTH);
        return ratio * ratio;
    }
}
