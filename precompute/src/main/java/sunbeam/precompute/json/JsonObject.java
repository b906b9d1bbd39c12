package sunbeam.precompute.json;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Choices.Origin;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Object of a JSON file: callers read it key by key, then {@link #requireNoOthers} refuses other keys. Messages name file, line, key, value
 * and remedy, in an {@link InputException}, or for settings in a {@link sunbeam.precompute.setting.SettingException}.
 */
public final class JsonObject {
    private final String file;
    private final String path;
    private final JsonPointer place;
    private final JsonNode node;
    private final Map<JsonPointer, Integer> lines;
    private final Set<String> known = new TreeSet<>();

    /**
     * @param path keys of the enclosing objects, each with a dot after it
     * @param place position of the object in the file
     * @param lines line of each value of the file, from 1
     */
    JsonObject(String file, String path, JsonPointer place, JsonNode node, Map<JsonPointer, Integer> lines) {
        this.file = file;
        this.path = path;
        this.place = place;
        this.node = node;
        this.lines = lines;
    }

    public Optional<JsonNode> find(String key) {
        known.add(key);
        return Optional.ofNullable(node.get(key));
    }

    public boolean has(String key) {
        return find(key).isPresent();
    }

    public List<String> others() {
        List<String> keys = new ArrayList<>();
        node.fieldNames().forEachRemaining(keys::add);
        keys.removeAll(known);
        return keys;
    }

    public JsonNode required(String key, String example) {
        return find(key)
                .orElseThrow(() -> new InputException(Text.format(
                        "%s, line %d: the key %s is missing; add for example %s: %s",
                        file, lines.get(place), Quoted.of(path + key), Quoted.of(key), example)));
    }

    public JsonObject object(String key, String example) {
        return inner(key, required(key, example), place.appendProperty(key));
    }

    public Optional<JsonObject> findObject(String key) {
        return find(key).map(value -> inner(key, value, place.appendProperty(key)));
    }

    public List<JsonObject> objects(String key, int most) {
        JsonNode list = find(key).orElse(MissingNode.getInstance());
        if (!list.isMissingNode() && (!list.isArray() || list.size() > most)) {
            throw complaint(key, "must be a list of at most " + most + " objects, [ { ... } ]");
        }
        return IntStream.range(0, list.size())
                .mapToObj(i -> inner(key, list.get(i), place.appendProperty(key).appendIndex(i)))
                .toList();
    }

    private JsonObject inner(String key, JsonNode value, JsonPointer at) {
        if (!value.isObject()) {
            throw complaint(key, "must be an object, { ... }");
        }
        return new JsonObject(file, path + key + ".", at, value, lines);
    }

    public String text(String key, JsonNode value) {
        if (!value.isTextual()) {
            throw complaint(key, "must be a text in quotes");
        }
        return value.textValue();
    }

    /** Parses a text with a unit; {@code parse} may throw IllegalArgumentException. */
    public <T> T quantity(String key, JsonNode value, Function<String, T> parse) {
        if (!value.isTextual()) {
            throw complaint(key, "must be a text in quotes with its unit, such as \"65 um\" or \"30 deg\"");
        }
        return checked(key, () -> parse.apply(value.textValue()));
    }

    public double number(String key, JsonNode value, double least, double most) {
        if (!value.isNumber()) {
            throw complaint(key, "must be a number without quotes and unit");
        }
        double number = value.doubleValue();
        if (!(number >= least && number <= most)) {
            throw complaint(
                    key,
                    Text.format(
                            "%s is out of range; give %s to %s",
                            Decimals.format(number), Decimals.format(least), Decimals.format(most)));
        }
        return number;
    }

    public List<JsonNode> sequence(String key, JsonNode value, int count) {
        if (!value.isArray() || value.size() != count) {
            throw complaint(key, "must be a list of " + count + " values, [ ... ]");
        }
        return IntStream.range(0, count).mapToObj(value::get).toList();
    }

    /**
     * Returns the values of those settings whose {@link Setting#fileKey} this object has.
     *
     * @throws sunbeam.precompute.setting.SettingException for a value that its setting does not accept
     */
    public Choices choices(Collection<? extends Setting<?>> settings) {
        Choices choices = Choices.at(origin());
        for (Setting<?> setting : settings) {
            Optional<JsonNode> value = find(setting.fileKey());
            choices = value.isEmpty() ? choices : choices.parsed(setting, written(setting, value.get()), origin());
        }
        return choices;
    }

    /** Writes settings as {@link #choices} reads them. */
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

    private String written(Setting<?> setting, JsonNode value) {
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
                if (!value.isBoolean()) {
                    throw complaint(key, "must be true or false, without quotes");
                }
                yield value.asText();
            }
            case NUMBER -> {
                if (value.isTextual() && Decimals.parse(value.textValue()).isEmpty()) {
                    yield value.textValue();
                }
                yield Decimals.format(number(key, value, -Double.MAX_VALUE, Double.MAX_VALUE));
            }
        };
    }

    public Origin origin() {
        return new KeyOrigin(this, Optional.empty());
    }

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

    public InputException complaint(String key, String problem) {
        return new InputException(name(key) + ": " + problem);
    }

    /** An IllegalArgumentException of the action becomes an {@link InputException}. */
    public <T> T checked(String key, Supplier<T> action) {
        try {
            return action.get();
        } catch (IllegalArgumentException wrong) {
            throw new InputException(name(key) + ": " + wrong.getMessage(), wrong);
        }
    }

    public void requireNoOthers() {
        for (String key : others()) {
            throw complaint(key, "unknown key; known are " + String.join(", ", known));
        }
    }

    /** Returns file, line and key for messages; the line is that of this object if the key is absent. */
    public String name(String key) {
        int line = lines.getOrDefault(place.appendProperty(key), lines.get(place));
        return Text.format("%s, line %d: %s", file, line, Quoted.of(path + key));
    }
}
