package sunbeam.app.json;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import sunbeam.app.input.InputException;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Decimals;

/**
 * An object of a JSON file, asked key by key. Afterwards {@link #requireNoOthers} finds the keys that nobody asked for.
 * Every complaint is an {@link InputException} in one line: file, line, key, value, remedy.
 */
public final class JsonObject {
    private final String file;
    private final String path;
    private final JsonValue.Members members;
    private final Set<String> asked = new TreeSet<>();

    JsonObject(String file, String path, JsonValue.Members members) {
        this.file = file;
        this.path = path;
        this.members = members;
    }

    /** The value of a key, where it is there. */
    public Optional<JsonValue> find(String key) {
        asked.add(key);
        return Optional.ofNullable(members.members().get(key));
    }

    /** Whether the key is there. */
    public boolean has(String key) {
        return find(key).isPresent();
    }

    /** The value of a key that must be there. */
    public JsonValue required(String key, String example) {
        return find(key)
                .orElseThrow(() -> new InputException("%s, line %d: the key %s is missing; add for example %s: %s"
                        .formatted(file, members.line(), Quoted.of(path + key), Quoted.of(key), example)));
    }

    /** The object of a key that must be there. */
    public JsonObject object(String key, String example) {
        return inner(key, required(key, example));
    }

    /** The object of a key, where it is there. */
    public Optional<JsonObject> findObject(String key) {
        return find(key).map(value -> inner(key, value));
    }

    private JsonObject inner(String key, JsonValue value) {
        if (value instanceof JsonValue.Members inside) {
            return new JsonObject(file, path + key + ".", inside);
        }
        throw complaint(key, value, "must be an object, { ... }");
    }

    /** The text of a key, where it is there. */
    public Optional<String> text(String key) {
        return find(key).map(value -> text(key, value));
    }

    /** A value as text. */
    public String text(String key, JsonValue value) {
        if (value instanceof JsonValue.Text text) {
            return text.text();
        }
        throw complaint(key, value, "must be a text in quotes");
    }

    /**
     * A text put through a function.
     *
     * @param parse may throw IllegalArgumentException with a message for the user
     */
    public <T> Optional<T> parsed(String key, Function<String, T> parse) {
        return find(key).map(value -> parsed(key, value, parse));
    }

    /** As {@link #parsed(String, Function)}, of a value. */
    public <T> T parsed(String key, JsonValue value, Function<String, T> parse) {
        if (!(value instanceof JsonValue.Text text)) {
            String remedy = value instanceof JsonValue.Numeral
                    ? "must be a text in quotes; a length or an angle needs its unit, such as \"65 um\" or \"30 deg\""
                    : "must be a text in quotes";
            throw complaint(key, value, remedy);
        }
        try {
            return parse.apply(text.text());
        } catch (IllegalArgumentException wrong) {
            throw complaint(key, value, wrong.getMessage());
        }
    }

    /** The number of a key, where it is there. */
    public OptionalDouble number(String key, double least, double most) {
        return find(key)
                .map(value -> OptionalDouble.of(number(key, value, least, most)))
                .orElse(OptionalDouble.empty());
    }

    /** A value as a number between bounds. */
    public double number(String key, JsonValue value, double least, double most) {
        if (!(value instanceof JsonValue.Numeral number)) {
            throw complaint(key, value, "must be a number without quotes and unit");
        }
        if (!(number.value() >= least && number.value() <= most)) {
            throw complaint(
                    key,
                    value,
                    "%s is out of range; give %s to %s"
                            .formatted(Decimals.format(number.value()), Decimals.format(least), Decimals.format(most)));
        }
        return number.value();
    }

    /** A value as a list of so many values. */
    public List<JsonValue> sequence(String key, JsonValue value, int count) {
        if (value instanceof JsonValue.Sequence sequence && sequence.values().size() == count) {
            return sequence.values();
        }
        throw complaint(key, value, "must be a list of " + count + " values, [ ... ]");
    }

    /** An exception that names file, line and key. */
    public InputException complaint(String key, JsonValue value, String problem) {
        return new InputException(
                "%s, line %d: %s: %s".formatted(file, value.line(), Quoted.of(path + key), Quoted.oneLine(problem)));
    }

    /** As {@link #complaint(String, JsonValue, String)}; where the key is not there, with the object's line. */
    public InputException complaint(String key, String problem) {
        return complaint(key, members.members().getOrDefault(key, members), problem);
    }

    /**
     * The result of an action, whose IllegalArgumentException becomes a complaint about this key, or where it is not there,
     * about the object.
     */
    public <T> T checked(String key, Supplier<T> action) {
        try {
            return action.get();
        } catch (IllegalArgumentException wrong) {
            throw complaint(key, wrong.getMessage());
        }
    }

    /** Complains about the first key that was never asked for. */
    public void requireNoOthers() {
        for (Map.Entry<String, JsonValue> member : members.members().entrySet()) {
            if (!asked.contains(member.getKey())) {
                throw complaint(
                        member.getKey(), member.getValue(), "unknown key; known are " + String.join(", ", asked));
            }
        }
    }
}
