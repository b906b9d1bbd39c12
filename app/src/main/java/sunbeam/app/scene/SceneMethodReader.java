package sunbeam.app.scene;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.json.JsonObject;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.text.Quoted;

/** Which method, in the key {@code plan} of a scene, and what belongs to that method alone. */
final class SceneMethodReader {
    private final JsonObject plan;

    private SceneMethodReader(JsonObject plan) {
        this.plan = plan;
    }

    /** The method; {@code full} where none is named. */
    static MethodRequest read(Optional<JsonObject> plan) {
        return plan.map(object -> new SceneMethodReader(object).read())
                .orElseGet(() -> MethodRequest.of(MethodKind.FULL));
    }

    private MethodRequest read() {
        MethodKind kind = plan.parsed("method", SceneMethodReader::kind).orElse(MethodKind.FULL);
        Optional<PeriodInterpolation> interpolation =
                SceneValues.word(plan, "interpolation", PeriodInterpolation.class);
        OptionalInt replicas = SceneValues.integer(plan, "replicas", 1, Replicas.MOST);
        OptionalDouble spacing =
                SceneValues.length(plan, "spacing", MethodRequest.SMALLEST_SPACING, MethodRequest.LARGEST_SPACING);
        belongsTo(MethodKind.PQ, kind, "interpolation");
        belongsTo(MethodKind.PQ, kind, "replicas");
        belongsTo(MethodKind.GEM, kind, "spacing");
        return new MethodRequest(kind, interpolation.orElse(PeriodInterpolation.SINC), replicas, spacing);
    }

    private static MethodKind kind(String name) {
        return switch (name.strip()) {
            case "full" -> MethodKind.FULL;
            case "nmm" -> MethodKind.NMM;
            case "pq" -> MethodKind.PQ;
            case "gem" -> MethodKind.GEM;
            default ->
                throw new IllegalArgumentException(
                        Quoted.of(name) + " is no method for meshes; use full, nmm, pq or gem");
        };
    }

    private void belongsTo(MethodKind owner, MethodKind kind, String key) {
        if (kind != owner && plan.has(key)) {
            throw plan.complaint(
                    key,
                    plan.required(key, ""),
                    "belongs to method %s, not %s; remove it".formatted(owner.label(), kind.label()));
        }
    }
}
