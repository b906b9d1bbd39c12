package sunbeam.precompute.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * An object of a JSON file, asked key by key. Afterwards {@link #requireNoOthers} finds the keys that nobody asked for.
 * Every complaint is one line: file, line, key, value, remedy; a {@link JsonException}, or of settings a {@link
 * sunbeam.precompute.setting.SettingException}.
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

    /** The keys that nobody has asked for, in the file's order. */
    public List<String> others() {
        return members.members().keySet().stream()
                .filter(key -> !asked.contains(key))
                .toList();
    }

    /** The value of a key that must be there. */
    public JsonValue required(String key, String example) {
        return find(key)
                .orElseThrow(() -> new JsonException(Text.format(
                        "%s, line %d: the key %s is missing; add for example %s: %s",
                        file, members.line(), Quoted.of(path + key), Quoted.of(key), example)));
    }

    /** The object of a key that must be there. */
    public JsonObject object(String key, String example) {
        return inner(key, required(key, example));
    }

    /** The object of a key, where it is there. */
    public Optional<JsonObject> findObject(String key) {
        return find(key).map(value -> inner(key, value));
    }

    /** The objects in the list of a key, at most so many; none where it is not there. */
    public List<JsonObject> objects(String key, int most) {
        Optional<JsonValue> value = find(key);
        if (value.isEmpty()) {
            return List.of();
        }
        if (!(value.get() instanceof JsonValue.Sequence list) || list.values().size() > most) {
            throw complaint(key, value.get(), "must be a list of at most " + most + " objects, [ { ... } ]");
        }
        return list.values().stream().map(object -> inner(key, object)).toList();
    }

    private JsonObject inner(String key, JsonValue value) {
        if (value instanceof JsonValue.Members inside) {
            return new JsonObject(file, path + key + ".", inside);
        }
        throw complaint(key, value, "must be an object, { ... }");
    }

    /** A value as text. */
    public String text(String key, JsonValue value) {
        if (value instanceof JsonValue.Text text) {
            return text.text();
        }
        throw complaint(key, value, "must be a text in quotes");
    }

    /**
     * A text with a number and a unit put through a function.
     *
     * @param parse may throw IllegalArgumentException with a message for the user
     */
    public <T> T quantity(String key, JsonValue value, Function<String, T> parse) {
        if (!(value instanceof JsonValue.Text text)) {
            throw complaint(key, value, "must be a text in quotes with its unit, such as \"65 um\" or \"30 deg\"");
        }
        try {
            return parse.apply(text.text());
        } catch (IllegalArgumentException wrong) {
            throw complaint(key, value, wrong.getMessage());
        }
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
                    Text.format(
                            "%s is out of range; give %s to %s",
                            Decimals.format(number.value()), Decimals.format(least), Decimals.format(most)));
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

    /**
     * The settings that this object chooses, by their names in files.
     *
     * @throws sunbeam.precompute.setting.SettingException for a value that is none of its setting
     */
    public Choices choices(Collection<? extends Setting<?>> settings) {
        Choices choices = Choices.at(origin());
        for (Setting<?> setting : settings) {
            Optional<JsonValue> value = find(setting.fileKey());
            choices = value.isEmpty() ? choices : choices.parsed(setting, written(setting, value.get()), origin());
        }
        return choices;
    }

    /** Writes all that was chosen as keys of the object that is being written, so that {@link #choices} reads them again. */
    public static void write(JsonGenerator json, Choices choices) throws IOException {
        for (Setting<?> setting : choices.chosen()) {
            String value = choices.written(setting);
            json.writeFieldName(setting.fileKey());
            if (setting.kind().form() == ValueKind.Form.FLAG) {
                json.writeBoolean(Boolean.parseBoolean(value));
            } else if (setting.kind().form() == ValueKind.Form.NUMBER
                    && Decimals.parse(value).isPresent()) {
                json.writeNumber(value);
            } else {
                json.writeString(value);
            }
        }
    }

    /** The text that a setting's kind understands. */
    private String written(Setting<?> setting, JsonValue value) {
        String key = setting.fileKey();
        return switch (setting.kind().form()) {
            case TEXT -> text(key, value);
            case QUANTITY ->
                quantity(key, value, text -> {
                    if (Decimals.parse(text).isPresent()) {
                        throw new IllegalArgumentException(Quoted.of(text) + " has no unit; give "
                                + setting.kind().range());
                    }
                    return text;
                });
            case FLAG -> {
                if (!(value instanceof JsonValue.Word word)) {
                    throw complaint(key, value, "must be true or false, without quotes");
                }
                yield word.word();
            }
            case NUMBER -> {
                if (value instanceof JsonValue.Text word
                        && Decimals.parse(word.text()).isEmpty()) {
                    yield word.text();
                }
                yield Decimals.format(number(key, value, -Double.MAX_VALUE, Double.MAX_VALUE));
            }
        };
    }

    /** This object as the place where settings are chosen. */
    public Origin origin() {
        return new KeyOrigin(this, Optional.empty());
    }

    /** One key of this object as the place where settings are chosen, whichever a complaint is about. */
    public Origin originAt(String key) {
        return new KeyOrigin(this, Optional.of(key));
    }

    private record KeyOrigin(JsonObject object, Optional<String> key) implements Origin {
        @Override
        public Place place() {
            return Place.FILE;
        }

        @Override
        public String name(Setting<?> setting) {
            return setting.fileKey();
        }

        @Override
        public String complaint(Setting<?> setting, String value, String problem) {
            return object.name(key.orElse(setting.fileKey())) + ": " + (value + " " + problem).strip();
        }
    }

    /** An exception that names file, line and key. */
    public JsonException complaint(String key, JsonValue value, String problem) {
        return new JsonException(name(key, value) + ": " + problem);
    }

    /**
     * The result of an action, whose IllegalArgumentException becomes a complaint about this key, or where it is not there,
     * about the object.
     */
    public <T> T checked(String key, Supplier<T> action) {
        try {
            return action.get();
        } catch (IllegalArgumentException wrong) {
            throw new JsonException(name(key) + ": " + wrong.getMessage(), wrong);
        }
    }

    /** Complains about the first key that was never asked for. */
    public void requireNoOthers() {
        for (String key : others()) {
            throw complaint(key, members.members().get(key), "unknown key; known are " + String.join(", ", asked));
        }
    }

    /** A key with file and line, for messages; where it is not there, with the object's line. */
    public String name(String key) {
        return name(key, members.members().getOrDefault(key, members));
    }

    private String name(String key, JsonValue value) {
        return Text.format("%s, line %d: %s", file, value.line(), Quoted.of(path + key));
    }
}
