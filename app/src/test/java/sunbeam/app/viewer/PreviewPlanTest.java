package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import org.junit.jupiter.api.Test;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;

class PreviewPlanTest {
    private static SceneMethod method(MethodType type, Preset preset) {
        return new SceneMethod(Choices.none().with(METHOD, type).with(PRESET, preset));
    }

    @Test
    void nmmKeepsTheThesissPresetWhichWeighsNoOrders() {
        assertThat(PreviewPlan.of(method(NmmMethod.TYPE, Preset.THESIS)).isThesis())
                .isTrue();
        assertThat(PreviewPlan.of(method(NmmMethod.TYPE, Preset.NONE)).isThesis())
                .isFalse();
    }

    @Test
    void fullIsPlannedCoarselyAtTheSamePlace() {
        SceneMethod thesis = method(FullMethod.TYPE, Preset.THESIS);
        SceneMethod preview = PreviewPlan.of(thesis);
        assertThat(preview.isThesis()).isFalse();
        assertThat(preview.get(TOLERANCE)).isGreaterThan(thesis.get(TOLERANCE));
        assertThat(preview.area().origin()).isEqualTo(thesis.area().origin());
    }

    @Test
    void halfTheCoherenceLengthIsTakenWhileItsBlurStaysSmall() {
        SceneMethod sunlight = method(FullMethod.TYPE, Preset.NONE);
        SceneMethod preview = PreviewPlan.of(sunlight);
        assertThat(preview.get(COHERENCE_LENGTH)).isEqualTo(sunlight.get(COHERENCE_LENGTH) / 2);
        assertThat(PreviewPlan.radianceScale(sunlight, preview)).isEqualTo(0.25);

        SceneMethod blurred = sunlight.with(COHERENCE_LENGTH, 12e-6);
        assertThat(PreviewPlan.of(blurred).get(COHERENCE_LENGTH)).isEqualTo(12e-6);
        SceneMethod replicated = method(PqMethod.TYPE, Preset.NONE);
        assertThat(PreviewPlan.radianceScale(replicated, PreviewPlan.of(replicated)))
                .isEqualTo(1);
    }
}
