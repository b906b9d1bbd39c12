package sunbeam.precompute.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.util.JsonParserDelegate;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Quoted;

/** Reader of JSON files of at most 1 MiB that hold one object; a key may occur only once in an object. */
public final class JsonFile {
    private static final int MOST_BYTES = 1 << 20;
    private static final int DEEPEST = 20;
    private static final ObjectMapper JSON = new ObjectMapper(JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
            .build());

    private JsonFile() {}

    /** @throws InputException when it cannot be read, is too large or no JSON object */
    public static JsonObject read(Path file) {
        InputException.requireRegular(file);
        try (InputStream stream = Files.newInputStream(file)) {
            return read(file.toString(), stream);
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    /** Reads a stream, which stays open; messages have the name. */
    public static JsonObject read(String name, InputStream stream) throws IOException {
        byte[] content = stream.readNBytes(MOST_BYTES + 1);
        if (content.length > MOST_BYTES) {
            throw new InputException(name + " is larger than 1 MiB; name another file");
        }
        try (LineParser parser = new LineParser(name, JSON.createParser(content))) {
            return root(name, parser);
        }
    }

    private static JsonObject root(String name, LineParser parser) {
        try {
            if (parser.nextToken() != JsonToken.START_OBJECT) {
                throw new InputException(name + ", line 1: it must be one JSON object, { ... }");
            }
            JsonNode root = JSON.readTree(parser);
            if (parser.nextToken() != null) {
                throw parser.wrong("something follows the closing brace; remove it");
            }
            return new JsonObject(name, "", JsonPointer.empty(), root, parser.lines);
        } catch (IOException broken) {
            // Jackson's message is for programmers.
            int line = parser.currentLocation().getLineNr();
            int column = parser.currentLocation().getColumnNr();
            throw new InputException(
                    name + ", line " + line + ": no valid JSON near column " + column
                            + "; check quotes, commas and brackets (at most " + DEEPEST + " within each other)",
                    broken);
        }
    }

    /** Parser that records the line of each value and refuses a repeated key. */
    private static final class LineParser extends JsonParserDelegate {
        private final String name;
        private final Map<JsonPointer, Integer> lines = new HashMap<>();

        LineParser(String name, JsonParser parser) {
            super(parser);
            this.name = name;
        }

        @Override
        public JsonToken nextToken() throws IOException {
            JsonToken token = super.nextToken();
            if (token != null && !token.isStructEnd()) {
                JsonPointer place = getParsingContext().pathAsPointer();
                boolean known = lines.put(place, currentTokenLocation().getLineNr()) != null;
                if (known && token == JsonToken.FIELD_NAME) {
                    throw wrong("the key " + Quoted.of(currentName()) + " stands twice; remove one");
                }
            }
            return token;
        }

        private InputException wrong(String problem) {
            return new InputException(name + ", line " + currentTokenLocation().getLineNr() + ": " + problem);
        }
    }
}
