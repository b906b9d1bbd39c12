package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.PlanRequest.Preset;

class PreviewPlanTest {
    @Test
    void nmmKeepsTheThesissPresetWhichWeighsNoOrders() {
        assertThat(PreviewPlan.of(MethodKind.NMM, PlanRequest.of(Preset.THESIS)).isThesis())
                .isTrue();
        assertThat(PreviewPlan.of(MethodKind.NMM, PlanRequest.of(Preset.NONE)).isThesis())
                .isFalse();
    }

    @Test
    void fullIsPlannedCoarselyAtTheSamePlace() {
        PlanRequest thesis = PlanRequest.of(Preset.THESIS);
        PlanRequest preview = PreviewPlan.of(MethodKind.FULL, thesis);
        assertThat(preview.isThesis()).isFalse();
        assertThat(preview.tolerance()).isGreaterThan(thesis.tolerance());
        assertThat(preview.windowOrigin()).isEqualTo(thesis.windowOrigin());
    }

    @Test
    void halfTheCoherenceLengthIsTakenWhileItsBlurStaysSmall() {
        PlanRequest sunlight = PlanRequest.of(Preset.NONE);
        PlanRequest preview = PreviewPlan.of(MethodKind.FULL, sunlight);
        assertThat(preview.window().coherenceLength())
                .isEqualTo(sunlight.window().coherenceLength() / 2);
        assertThat(PreviewPlan.radianceScale(sunlight, preview)).isEqualTo(0.25);

        PlanRequest blurred = PlanChange.coherenceLength(sunlight, 12e-6);
        assertThat(PreviewPlan.of(MethodKind.FULL, blurred).window().coherenceLength())
                .isEqualTo(12e-6);
        PlanRequest replicated = PreviewPlan.of(MethodKind.PQ, sunlight);
        assertThat(PreviewPlan.radianceScale(sunlight, replicated)).isEqualTo(1);
    }
}
