package sunbeam.app.viewer;

import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.scene.Scene;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.resample.PeriodInterpolation;

/** The methods that the viewer offers. */
enum MethodChoice {
    FULL("full", MethodKind.FULL, PlanRequest.Preset.NONE),
    FULL_THESIS("full, thesis", MethodKind.FULL, PlanRequest.Preset.THESIS),
    NMM("nmm", MethodKind.NMM, PlanRequest.Preset.NONE),
    NMM_THESIS("nmm, thesis", MethodKind.NMM, PlanRequest.Preset.THESIS),
    PQ_SINC("pq, sinc", MethodKind.PQ, PlanRequest.Preset.NONE),
    PQ_LINEAR("pq, linear", MethodKind.PQ, PlanRequest.Preset.NONE),
    GEM("gem (comparison)", MethodKind.GEM, PlanRequest.Preset.NONE);

    private final String label;
    private final MethodKind kind;
    private final PlanRequest.Preset preset;

    MethodChoice(String label, MethodKind kind, PlanRequest.Preset preset) {
        this.label = label;
        this.kind = kind;
        this.preset = preset;
    }

    /** What a scene has; a preset counts only for the methods that are offered with it. */
    static MethodChoice of(Scene scene) {
        boolean thesis = scene.plan().isThesis();
        return switch (scene.method().kind()) {
            case NMM -> thesis ? NMM_THESIS : NMM;
            case PQ -> scene.method().interpolation() == PeriodInterpolation.LINEAR ? PQ_LINEAR : PQ_SINC;
            case GEM -> GEM;
            default -> thesis ? FULL_THESIS : FULL;
        };
    }

    /**
     * A scene with this method. What only another method has is given up; the average becomes coherent for {@code pq},
     * which has no other, and the mesh's own again afterwards.
     *
     * @param spacing of the lines in metres, for {@code gem}
     */
    Scene apply(Scene scene, double spacing) {
        PeriodInterpolation interpolation = this == PQ_LINEAR ? PeriodInterpolation.LINEAR : PeriodInterpolation.SINC;
        MethodRequest plain = MethodRequest.of(kind);
        MethodRequest method = switch (kind) {
            case PQ -> new MethodRequest(kind, interpolation, scene.method().replicas(), OptionalDouble.empty());
            case GEM -> new MethodRequest(kind, interpolation, plain.replicas(), OptionalDouble.of(spacing));
            default -> plain;
        };
        PlanRequest plan = PlanChange.preset(scene.plan(), preset);
        Optional<Average> average = average(scene);
        return scene.withMethod(method, average.isEmpty() ? plan : PlanChange.average(plan, average.get()));
    }

    private Optional<Average> average(Scene scene) {
        boolean wasReplicated = scene.method().kind() == MethodKind.PQ;
        if (kind == MethodKind.PQ) {
            return Optional.of(Average.COHERENT);
        }
        return wasReplicated ? Optional.of(Average.ENSEMBLE) : scene.plan().average();
    }

    /** Whether the tolerance decides anything. */
    boolean hasTolerance() {
        return preset == PlanRequest.Preset.NONE && kind != MethodKind.GEM;
    }

    /** Whether there is more than one average. */
    boolean hasAverages() {
        return kind != MethodKind.PQ && kind != MethodKind.GEM;
    }

    /** Whether the spacing of the lines is asked for. */
    boolean hasSpacing() {
        return kind == MethodKind.GEM;
    }

    @Override
    public String toString() {
        return label;
    }
}
