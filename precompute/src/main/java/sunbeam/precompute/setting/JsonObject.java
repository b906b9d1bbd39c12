package sunbeam.precompute.setting;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.util.JsonParserDelegate;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.setting.ChoiceOrigin.Place;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Object of a JSON file of at most 1 MiB: callers read it key by key, then {@link #requireNoOthers} refuses other keys. A key may occur only
 * once in an object. Messages name file, line, key, value and remedy, in an {@link InputException}, or for settings in a {@link
 * sunbeam.precompute.setting.SettingException}.
 */
public final class JsonObject {
    private static final int MOST_BYTES = 1 << 20;
    private static final int DEEPEST = 20;
    private static final ObjectMapper JSON = new ObjectMapper(JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
            .build());

    private final LineParser parser;
    private final JsonPointer place;
    // Keys of the enclosing objects, each with a dot after it.
    private final String path;
    private final JsonNode node;
    private final Set<String> known = new TreeSet<>();

    private JsonObject(LineParser parser, JsonPointer place, String path, JsonNode node) {
        this.parser = parser;
        this.place = place;
        this.path = path;
        this.node = node;
    }

    /** Throws InputException when the file cannot be read, is too large or no JSON object. */
    public static JsonObject read(Path file) {
        InputException.requireRegular(file);
        try (InputStream stream = Files.newInputStream(file)) {
            // A file of the kernel has no size, and its reading may wait forever.
            int most = (int) Math.min(MOST_BYTES + 1, Files.size(file));
            return read(file.toString(), new ByteArrayInputStream(stream.readNBytes(most)));
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    /** Reads a stream, which stays open; messages have the name. */
    public static JsonObject read(String name, InputStream stream) throws IOException {
        byte[] content = stream.readNBytes(MOST_BYTES + 1);
        InputException.refuseIf(content.length > MOST_BYTES, name + " is larger than 1 MiB; name another file");
        try (LineParser parser = new LineParser(name, JSON.createParser(content))) {
            return parser.root();
        }
    }

    /** Parser that records the line, from 1, of each value and refuses a repeated key. */
    private static final class LineParser extends JsonParserDelegate {
        private final String name;
        private final Map<JsonPointer, Integer> lines = new HashMap<>();

        LineParser(String name, JsonParser parser) {
            super(parser);
            this.name = name;
        }

        JsonObject root() {
            try {
                InputException.refuseIf(
                        nextToken() != JsonToken.START_OBJECT, name + ", line 1: it must be one JSON object, { ... }");
                JsonNode root = JSON.readTree(this);
                InputException.refuseIf(nextToken() != null, here() + "something follows the closing brace; remove it");
                return new JsonObject(this, JsonPointer.empty(), "", root);
            } catch (IOException broken) {
                // Jackson's message is for programmers.
                throw new InputException(
                        name + ", line " + currentLocation().getLineNr() + ": no valid JSON near column "
                                + currentLocation().getColumnNr()
                                + "; check quotes, commas and brackets (at most " + DEEPEST + " within each other)",
                        broken);
            }
        }

        @Override
        public JsonToken nextToken() throws IOException {
            JsonToken token = super.nextToken();
            if (token != null && !token.isStructEnd()) {
                JsonPointer at = getParsingContext().pathAsPointer();
                boolean known = lines.put(at, currentTokenLocation().getLineNr()) != null;
                if (known && token == JsonToken.FIELD_NAME) {
                    throw new InputException(
                            here() + "the key " + Text.quoted(currentName()) + " stands twice; remove one");
                }
            }
            return token;
        }

        private String here() {
            return name + ", line " + currentTokenLocation().getLineNr() + ": ";
        }
    }

    public Optional<JsonNode> find(String key) {
        known.add(key);
        return Optional.ofNullable(node.get(key));
    }

    public boolean has(String key) {
        return find(key).isPresent();
    }

    public List<String> others() {
        return node.propertyStream()
                .map(Map.Entry::getKey)
                .filter(key -> !known.contains(key))
                .toList();
    }

    public JsonNode required(String key, String example) {
        return find(key)
                .orElseThrow(() -> new InputException(Text.format(
                        "%s, line %d: the key %s is missing%s; add for example %s: %s",
                        parser.name,
                        parser.lines.get(place),
                        Text.quoted(path + key),
                        Text.nearest(key, others())
                                .map(name -> ", and " + Text.quoted(name) + " is unknown")
                                .orElse(""),
                        Text.quoted(key),
                        example)));
    }

    public JsonObject object(String key, String example) {
        return inner(key, required(key, example), place.appendProperty(key));
    }

    public Optional<JsonObject> findObject(String key) {
        return find(key).map(value -> inner(key, value, place.appendProperty(key)));
    }

    public List<JsonObject> objects(String key, int most) {
        JsonNode list = find(key).orElseGet(JSON::createArrayNode);
        require(
                list.isArray() && list.size() <= most,
                key,
                "must be a list of at most " + most + " objects, [ { ... } ]");
        return IntStream.range(0, list.size())
                .mapToObj(i -> inner(key, list.get(i), place.appendProperty(key).appendIndex(i)))
                .toList();
    }

    private JsonObject inner(String key, JsonNode value, JsonPointer at) {
        require(value.isObject(), key, "must be an object, { ... }");
        return new JsonObject(parser, at, path + key + ".", value);
    }

    public String text(String key, JsonNode value) {
        require(value.isTextual(), key, "must be a text in quotes");
        return value.textValue();
    }

    /** Parses a text with a unit; {@code parse} may throw IllegalArgumentException. */
    public <T> T quantity(String key, JsonNode value, Function<String, T> parse) {
        require(value.isTextual(), key, "must be a text in quotes with its unit, such as \"65 um\" or \"30 deg\"");
        return checked(key, () -> parse.apply(value.textValue()));
    }

    public double number(String key, JsonNode value, double least, double most) {
        require(value.isNumber(), key, "must be a number without quotes and unit");
        double number = value.doubleValue();
        String range = "; give " + Decimals.format(least) + " to " + Decimals.format(most);
        require(number >= least && number <= most, key, Decimals.format(number) + " is out of range" + range);
        return number;
    }

    public List<JsonNode> sequence(String key, JsonNode value, int count) {
        require(value.isArray() && value.size() == count, key, "must be a list of " + count + " values, [ ... ]");
        return value.valueStream().toList();
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
            case QUANTITY -> {
                String text = quantity(key, value, Function.identity());
                boolean hasUnit = Decimals.parse(text).isEmpty();
                require(
                        hasUnit,
                        key,
                        Text.quoted(text) + " has no unit; give "
                                + setting.kind().range());
                yield text;
            }
            case FLAG -> {
                require(value.isBoolean(), key, "must be true or false, without quotes");
                yield value.asText();
            }
            case NUMBER -> {
                boolean word =
                        value.isTextual() && Decimals.parse(value.textValue()).isEmpty();
                yield word
                        ? value.textValue()
                        : Decimals.format(number(key, value, -Double.MAX_VALUE, Double.MAX_VALUE));
            }
        };
    }

    public ChoiceOrigin origin() {
        return new KeyOrigin(Place.FILE, this, Optional.empty());
    }

    public ChoiceOrigin originAt(String key) {
        return new KeyOrigin(Place.FILE, this, Optional.of(key));
    }

    private record KeyOrigin(Place place, JsonObject object, Optional<String> key) implements ChoiceOrigin {
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

    private void require(boolean condition, String key, String problem) {
        if (!condition) {
            throw complaint(key, problem);
        }
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
        others().forEach(key -> require(false, key, "unknown key; known are " + String.join(", ", known)));
    }

    /** Returns file, line and key for messages; the line is that of this object if the key is absent. */
    public String name(String key) {
        int line = parser.lines.getOrDefault(place.appendProperty(key), parser.lines.get(place));
        return parser.name + ", line " + line + ": " + Text.quoted(path + key);
    }
}
