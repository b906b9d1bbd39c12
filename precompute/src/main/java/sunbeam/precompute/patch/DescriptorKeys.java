package sunbeam.precompute.patch;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import sunbeam.precompute.text.Quoted;

/** The keys of a JSON file that is one flat object of texts, each with the line it stands on. */
final class DescriptorKeys {
    /** A descriptor is a handful of lines; anything near this size is another kind of file. */
    static final int MOST_BYTES = 1 << 20;

    private static final JsonFactory JSON = JsonFactory.builder()
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
            .build();

    private final Path file;
    private final Map<String, Value> values = new LinkedHashMap<>();

    private record Value(String text, int line) {}

    private DescriptorKeys(Path file) {
        this.file = file;
    }

    /**
     * Reads the file.
     *
     * @throws PatchException when it is missing, too large, no JSON object, or has a value that is no text
     */
    static DescriptorKeys read(Path file) {
        InputFiles.requireReadable(file);
        DescriptorKeys keys = new DescriptorKeys(file);
        try (JsonParser parser = JSON.createParser(content(file))) {
            keys.parse(parser);
        } catch (JsonProcessingException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNr();
            String problem = e.getOriginalMessage().lines().findFirst().orElse("broken");
            throw new PatchException(
                    "%s, line %d: no valid JSON (%s); mend the line".formatted(file, line, problem), e);
        } catch (IOException e) {
            throw new PatchException(file + " cannot be read (" + e.getMessage() + "); check the file", e);
        }
        return keys;
    }

    private static byte[] content(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            byte[] content = in.readNBytes(MOST_BYTES + 1);
            if (content.length > MOST_BYTES) {
                throw new PatchException(
                        file + " is larger than 1 MiB, so it is no patch descriptor; name another file");
            }
            return content;
        }
    }

    private void parse(JsonParser parser) throws IOException {
        if (parser.nextToken() != JsonToken.START_OBJECT) {
            throw new PatchException(file + " is no patch descriptor: it must be one JSON object, { ... }");
        }
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String key = parser.currentName();
            JsonToken token = parser.nextToken();
            int line = parser.currentTokenLocation().getLineNr();
            if (token != JsonToken.VALUE_STRING) {
                String remedy = token.isNumeric()
                        ? "write lengths as text with their unit, such as \"65 um\""
                        : "write it as text in quotes";
                throw new PatchException("%s is no text; %s".formatted(name(key, line), remedy));
            }
            values.put(key, new Value(parser.getText(), line));
        }
        if (parser.nextToken() != null) {
            throw new PatchException("%s, line %d: something follows the closing brace; remove it"
                    .formatted(file, parser.currentTokenLocation().getLineNr()));
        }
    }

    /** @throws PatchException that names the first key which is not among the known ones */
    void requireOnly(Iterable<String> known) {
        for (Map.Entry<String, Value> entry : values.entrySet()) {
            boolean found = false;
            for (String key : known) {
                found |= key.equals(entry.getKey());
            }
            if (!found) {
                throw new PatchException("%s is an unknown key; known are %s"
                        .formatted(name(entry.getKey(), entry.getValue().line()), String.join(", ", known)));
            }
        }
    }

    /**
     * A key's text.
     *
     * @param example a value, for the message
     * @throws PatchException when the key is missing
     */
    String required(String key, String example) {
        Value value = values.get(key);
        if (value == null) {
            throw new PatchException(
                    "%s lacks the key \"%s\"; add for example \"%s\": \"%s\"".formatted(file, key, key, example));
        }
        return value.text();
    }

    /** A key's text, where the key is there. */
    Optional<String> optional(String key) {
        return Optional.ofNullable(values.get(key)).map(Value::text);
    }

    /**
     * A key's value, where the key is there.
     *
     * @param parse from the text; may throw IllegalArgumentException with a message for the user
     */
    <T> Optional<T> optional(String key, Function<String, T> parse) {
        return optional(key).map(text -> {
            try {
                return parse.apply(text);
            } catch (IllegalArgumentException e) {
                throw new PatchException(name(key) + ": " + e.getMessage(), e);
            }
        });
    }

    /** The key with file and line, as messages name it. */
    String name(String key) {
        return name(key, values.get(key).line());
    }

    private String name(String key, int line) {
        return "%s, line %d: %s".formatted(file, line, Quoted.of(key));
    }
}
