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
    void fullIsPlannedCoarselyUnderTheSameWindow() {
        PlanRequest thesis = PlanRequest.of(Preset.THESIS);
        PlanRequest preview = PreviewPlan.of(MethodKind.FULL, thesis);
        assertThat(preview.isThesis()).isFalse();
        assertThat(preview.tolerance()).isGreaterThan(thesis.tolerance());
        assertThat(preview.windowOrigin()).isEqualTo(thesis.windowOrigin());
    }
}
