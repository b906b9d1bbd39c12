package sunbeam.app.scene;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.json.JsonObject;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;

/**
 * The key {@code plan} of a scene but for the method. On a mesh the ensemble average is the default: a pixel sees many
 * coherence areas. {@code pq} has none.
 */
final class ScenePlanReader {
    private static final int MOST_TERMS = 500;

    private final JsonObject plan;

    private ScenePlanReader(JsonObject plan) {
        this.plan = plan;
    }

    /** @param kind the method that the plan is for */
    static PlanRequest read(Optional<JsonObject> plan, MethodKind kind) {
        return plan.map(object -> new ScenePlanReader(object).read(kind)).orElseGet(ScenePlanReader::standard);
    }

    /** What a scene without this key has. */
    static PlanRequest standard() {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                Tolerances.STANDARD,
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.of(Average.ENSEMBLE));
    }

    private PlanRequest read(MethodKind kind) {
        PlanRequest.Preset preset =
                SceneValues.word(plan, "preset", PlanRequest.Preset.class).orElse(PlanRequest.Preset.NONE);
        if (preset == PlanRequest.Preset.THESIS && plan.has("tolerance")) {
            throw plan.complaint(
                    "tolerance", "contradicts preset thesis, whose choices keep no tolerance; remove one of them");
        }
        PlanRequest request = new PlanRequest(
                preset,
                plan.number("tolerance", Tolerances.FINEST, Tolerances.COARSEST).orElse(Tolerances.STANDARD),
                SceneValues.word(plan, "expansion", ExpansionKind.class),
                SceneValues.integer(plan, "terms", 1, MOST_TERMS),
                SceneValues.integer(plan, "radius", 0, Neighbourhood.MAXIMUM_RADIUS),
                SceneValues.word(plan, "anchor", Neighbourhood.Anchor.class),
                SceneValues.length(plan, "wavelengthStep", 1e-12, 200e-9),
                SceneValues.word(plan, "windowOrigin", WindowOrigin.class),
                SceneValues.length(plan, "coherenceLength", 100e-9, 10e-3),
                Optional.of(SceneValues.word(plan, "average", Average.class)
                        .orElse(kind == MethodKind.PQ ? Average.COHERENT : Average.ENSEMBLE)));
        if (request.anchor().isPresent() && request.radius().isEmpty() && !request.isThesis()) {
            throw plan.complaint(
                    "anchor",
                    plan.required("anchor", ""),
                    "is the middle of a neighbourhood of bins, but no radius is given; add for example \"radius\": 3");
        }
        if (kind == MethodKind.PQ) {
            checkReplicas(request);
        }
        plan.requireNoOthers();
        return request;
    }

    /** Replicas lie at one place and have sharp edges. */
    private void checkReplicas(PlanRequest request) {
        if (request.average().orElseThrow() == Average.ENSEMBLE) {
            throw plan.complaint(
                    "average",
                    plan.required("average", "\"coherent\""),
                    "ensemble is not for method pq, whose replicas lie at one place; write coherent, or use method full");
        }
        for (String key : new String[] {"radius", "anchor"}) {
            if (plan.has(key)) {
                throw plan.complaint(
                        key,
                        plan.required(key, ""),
                        "is not for method pq, which has no neighbourhood of bins; remove it");
            }
        }
    }
}
