package sunbeam.app.scene;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.PlanRequest;

/** Writes the keys {@code patch} and {@code plan}. */
final class ScenePlanWriter {
    private final JsonGenerator json;

    ScenePlanWriter(JsonGenerator json) {
        this.json = json;
    }

    void patch(PatchRequest patch, SceneNames names) throws IOException {
        String file = names.of(patch.patch());
        if (patch.equals(PatchRequest.of(patch.patch()))) {
            json.writeStringField("patch", file);
            return;
        }
        json.writeObjectFieldStart("patch");
        json.writeStringField("file", file);
        length("width", patch.width());
        length("height", patch.extent());
        length("maxHeight", patch.maxHeight());
        word("channel", patch.channel());
        word("levelling", patch.levelling());
        json.writeEndObject();
    }

    void plan(MethodRequest method, PlanRequest plan) throws IOException {
        json.writeObjectFieldStart("plan");
        json.writeStringField("method", method.kind().label());
        if (method.kind() == MethodKind.PQ) {
            word("interpolation", Optional.of(method.interpolation()));
        }
        integer("replicas", method.replicas());
        length("spacing", boxed(method.spacing()));
        if (plan.isThesis()) {
            word("preset", Optional.of(plan.preset()));
        } else {
            json.writeNumberField("tolerance", plan.tolerance());
        }
        word("average", plan.average());
        word("expansion", plan.expansion());
        integer("terms", plan.terms());
        integer("radius", plan.radius());
        word("anchor", plan.anchor());
        length("wavelengthStep", boxed(plan.wavelengthStep()));
        word("windowOrigin", plan.origin());
        length("coherenceLength", boxed(plan.coherenceLength()));
        json.writeEndObject();
    }

    private static Optional<Double> boxed(OptionalDouble value) {
        return value.isPresent() ? Optional.of(value.getAsDouble()) : Optional.empty();
    }

    private void length(String key, Optional<Double> metres) throws IOException {
        if (metres.isPresent()) {
            json.writeStringField(key, SceneWriter.length(metres.get()));
        }
    }

    private void integer(String key, OptionalInt value) throws IOException {
        if (value.isPresent()) {
            json.writeNumberField(key, value.getAsInt());
        }
    }

    private void word(String key, Optional<? extends Enum<?>> value) throws IOException {
        if (value.isPresent()) {
            json.writeStringField(key, value.get().name().toLowerCase(Locale.ROOT));
        }
    }
}
