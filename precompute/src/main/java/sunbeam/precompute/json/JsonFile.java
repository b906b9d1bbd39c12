package sunbeam.precompute.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.text.Text;

/** Reads JSON files of at most 1 MiB that hold one object. Keys may not occur twice. */
public final class JsonFile {
    private static final int MOST_BYTES = 1 << 20;
    private static final int DEEPEST = 20;
    private static final JsonFactory JSON = JsonFactory.builder()
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
            .build();

    // What the library tells programmers, not users.
    private static final Pattern ADVICE =
            Pattern.compile(", from `[^`]*`|: enable `[^`]*` to allow| \\(not recognized as one since [^)]*\\)");

    private JsonFile() {}

    /**
     * Reads a file.
     *
     * @throws JsonException when it is too large or no JSON object; the message names file and line
     * @throws IOException when it is missing or cannot be read
     */
    public static JsonObject read(Path file) throws IOException {
        try (InputStream stream = Files.newInputStream(file)) {
            return read(file.toString(), stream);
        }
    }

    /**
     * Reads a stream, which stays open.
     *
     * @param name what messages call it
     */
    public static JsonObject read(String name, InputStream stream) throws IOException {
        byte[] content = stream.readNBytes(MOST_BYTES + 1);
        if (content.length > MOST_BYTES) {
            throw new JsonException(name + " is larger than 1 MiB; name another file");
        }
        try (JsonParser parser = JSON.createParser(content)) {
            return read(name, parser);
        }
    }

    private static JsonObject read(String name, JsonParser parser) throws IOException {
        try {
            if (parser.nextToken() != JsonToken.START_OBJECT) {
                throw new JsonException(name + ", line 1: it must be one JSON object, { ... }");
            }
            JsonValue.Members all = members(parser);
            if (parser.nextToken() != null) {
                throw new JsonException(
                        name + ", line " + line(parser) + ": something follows the closing brace; remove it");
            }
            return new JsonObject(name, "", all);
        } catch (JsonProcessingException broken) {
            // Complaints about what is too long or too deep come without their place.
            JsonLocation place = broken.getLocation() == null ? parser.currentLocation() : broken.getLocation();
            throw new JsonException(
                    Text.format(
                            "%s, line %d: no valid JSON (%s); mend the line",
                            name, place.getLineNr(), Quoted.oneLine(problem(broken))),
                    broken);
        }
    }

    private static String problem(JsonProcessingException broken) {
        String first = broken.getOriginalMessage().lines().findFirst().orElse("broken");
        return ADVICE.matcher(first).replaceAll("");
    }

    private static int line(JsonParser parser) {
        return parser.currentTokenLocation().getLineNr();
    }

    private static JsonValue.Members members(JsonParser parser) throws IOException {
        int line = line(parser);
        Map<String, JsonValue> values = new LinkedHashMap<>();
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String key = parser.currentName();
            parser.nextToken();
            values.put(key, value(parser));
        }
        return new JsonValue.Members(values, line);
    }

    private static JsonValue value(JsonParser parser) throws IOException {
        int line = line(parser);
        return switch (parser.currentToken()) {
            case START_OBJECT -> members(parser);
            case START_ARRAY -> sequence(parser);
            case VALUE_STRING -> new JsonValue.Text(parser.getText(), line);
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new JsonValue.Numeral(parser.getDoubleValue(), line);
            default -> new JsonValue.Word(parser.getText(), line);
        };
    }

    private static JsonValue sequence(JsonParser parser) throws IOException {
        int line = line(parser);
        List<JsonValue> values = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            values.add(value(parser));
        }
        return new JsonValue.Sequence(values, line);
    }
}
