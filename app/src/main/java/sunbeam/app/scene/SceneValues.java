package sunbeam.app.scene;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import sunbeam.app.json.JsonObject;
import sunbeam.app.json.JsonValue;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Lengths;

/** Values of a scene's keys, where they are there; complaints name file, line and key. */
final class SceneValues {
    private SceneValues() {}

    /** One of an enum's constants, by its name in lower case. */
    static <E extends Enum<E>> Optional<E> word(JsonObject object, String key, Class<E> type) {
        return object.parsed(key, text -> {
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

    /** A whole number between bounds. */
    static OptionalInt integer(JsonObject object, String key, int least, int most) {
        Optional<JsonValue> value = object.find(key);
        if (value.isEmpty()) {
            return OptionalInt.empty();
        }
        double number = object.number(key, value.get(), least, most);
        if (number != Math.rint(number)) {
            throw object.complaint(key, value.get(), number + " is not a whole number");
        }
        return OptionalInt.of((int) number);
    }

    /** A length between bounds in metres. */
    static OptionalDouble length(JsonObject object, String key, double least, double most) {
        Optional<Double> metres = object.parsed(key, text -> {
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
