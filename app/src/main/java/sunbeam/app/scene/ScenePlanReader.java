package sunbeam.app.scene;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import sunbeam.app.json.JsonObject;
import sunbeam.app.json.JsonValue;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Lengths;

/** The key {@code plan} of a scene. On a mesh the ensemble average is the default: a pixel sees many coherence areas. */
final class ScenePlanReader {
    private static final int MOST_TERMS = 500;

    private final JsonObject plan;

    private ScenePlanReader(JsonObject plan) {
        this.plan = plan;
    }

    static PlanRequest read(Optional<JsonObject> plan) {
        return plan.map(object -> new ScenePlanReader(object).read()).orElseGet(ScenePlanReader::standard);
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

    private PlanRequest read() {
        checkMethod();
        PlanRequest request = new PlanRequest(
                word("preset", PlanRequest.Preset.class).orElse(PlanRequest.Preset.NONE),
                plan.number("tolerance", Tolerances.FINEST, Tolerances.COARSEST).orElse(Tolerances.STANDARD),
                word("expansion", ExpansionKind.class),
                integer("terms", 1, MOST_TERMS),
                integer("radius", 0, Neighbourhood.MAXIMUM_RADIUS),
                word("anchor", Neighbourhood.Anchor.class),
                length("wavelengthStep", 1e-12, 200e-9),
                word("windowOrigin", WindowOrigin.class),
                length("coherenceLength", 100e-9, 10e-3),
                Optional.of(word("average", Average.class).orElse(Average.ENSEMBLE)));
        plan.requireNoOthers();
        return request;
    }

    private void checkMethod() {
        plan.parsed("method", name -> {
            if (!name.equals("full")) {
                throw new IllegalArgumentException(Quoted.of(name) + " is no method for meshes; use full");
            }
            return name;
        });
    }

    private <E extends Enum<E>> Optional<E> word(String key, Class<E> type) {
        return plan.parsed(key, text -> {
            for (E constant : type.getEnumConstants()) {
                if (constant.name().toLowerCase(Locale.ROOT).equals(text.strip())) {
                    return constant;
                }
            }
            String names = Arrays.stream(type.getEnumConstants())
                    .map(constant -> constant.name().toLowerCase(Locale.ROOT))
                    .collect(Collectors.joining(", "));
            throw new IllegalArgumentException(Quoted.of(text) + " is not one of " + names);
        });
    }

    private OptionalInt integer(String key, int least, int most) {
        Optional<JsonValue> value = plan.find(key);
        if (value.isEmpty()) {
            return OptionalInt.empty();
        }
        double number = plan.number(key, value.get(), least, most);
        if (number != Math.rint(number)) {
            throw plan.complaint(key, value.get(), number + " is not a whole number");
        }
        return OptionalInt.of((int) number);
    }

    private OptionalDouble length(String key, double least, double most) {
        Optional<Double> metres = plan.parsed(key, text -> {
            double parsed = Lengths.parse(text);
            if (!(parsed >= least && parsed <= most)) {
                throw new IllegalArgumentException(Quoted.of(text) + " is out of range; give " + Lengths.format(least)
                        + " to " + Lengths.format(most));
            }
            return parsed;
        });
        return metres.isPresent() ? OptionalDouble.of(metres.get()) : OptionalDouble.empty();
    }
}
