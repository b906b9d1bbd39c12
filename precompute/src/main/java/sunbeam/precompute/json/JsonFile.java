package sunbeam.precompute.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import sunbeam.precompute.text.Quoted;

/** Reads JSON files of at most 1 MiB that hold one object. Keys may not occur twice. */
public final class JsonFile {
    private static final int MOST_BYTES = 1 << 20;
    private static final int DEEPEST = 20;
    private static final JsonFactory JSON = JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
            .build();
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final String name;
    private final JsonParser parser;
    private final Map<JsonPointer, Integer> lines = new HashMap<>();

    private JsonFile(String name, JsonParser parser) {
        this.name = name;
        this.parser = parser;
    }

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
     * @param name name of the file in messages
     */
    public static JsonObject read(String name, InputStream stream) throws IOException {
        byte[] content = stream.readNBytes(MOST_BYTES + 1);
        if (content.length > MOST_BYTES) {
            throw new JsonException(name + " is larger than 1 MiB; name another file");
        }
        try (JsonParser parser = JSON.createParser(content)) {
            return new JsonFile(name, parser).root();
        }
    }

    private JsonObject root() {
        try {
            if (parser.nextToken() != JsonToken.START_OBJECT) {
                throw new JsonException(name + ", line 1: it must be one JSON object, { ... }");
            }
            ObjectNode root = object();
            if (parser.nextToken() != null) {
                throw wrong("something follows the closing brace; remove it");
            }
            return new JsonObject(name, "", JsonPointer.empty(), root, lines);
        } catch (IOException broken) {
            // The parser's own words are for programmers.
            int line = parser.currentLocation().getLineNr();
            int column = parser.currentLocation().getColumnNr();
            throw new JsonException(
                    name + ", line " + line + ": no valid JSON near column " + column
                            + "; check quotes, commas and brackets (at most " + DEEPEST + " within each other)",
                    broken);
        }
    }

    private JsonException wrong(String problem) {
        return new JsonException(
                name + ", line " + parser.currentTokenLocation().getLineNr() + ": " + problem);
    }

    /** The value that the parser stands on, whose line is noted. */
    private JsonNode value() throws IOException {
        return switch (parser.currentToken()) {
            case START_OBJECT -> object();
            case START_ARRAY -> array();
            case VALUE_STRING -> NODES.textNode(parser.getText());
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> NODES.numberNode(parser.getDoubleValue());
            case VALUE_NULL -> NODES.nullNode();
            default -> NODES.booleanNode(parser.getBooleanValue());
        };
    }

    private void noteLine() {
        lines.put(
                parser.getParsingContext().pathAsPointer(),
                parser.currentTokenLocation().getLineNr());
    }

    private ObjectNode object() throws IOException {
        ObjectNode object = NODES.objectNode();
        noteLine();
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String key = parser.currentName();
            if (object.has(key)) {
                throw wrong("the key " + Quoted.of(key) + " stands twice; remove one");
            }
            parser.nextToken();
            noteLine();
            object.set(key, value());
        }
        return object;
    }

    private ArrayNode array() throws IOException {
        ArrayNode array = NODES.arrayNode();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            array.add(value());
        }
        return array;
    }
}
