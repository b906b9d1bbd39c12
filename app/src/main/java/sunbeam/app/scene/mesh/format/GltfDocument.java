package sunbeam.app.scene.mesh.format;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.ObjectMapper;
import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.model.io.JacksonUtils;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Quoted;

/**
 * Reads the JSON of glTF 2.0 into jgltf's classes. The reader of that library follows any address and takes memory
 * for all sizes that a file states; here it gets a text of known size, depth and number of values, and resolves nothing.
 */
final class GltfDocument {
    private static final int MOST_VALUES = 1_000_000;
    private static final JsonFactory JSON = JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(64).build())
            .build();
    private static final ObjectMapper MAPPER = mapper();
    /** Required extensions that leave positions, directions and faces as they are, or that are read. */
    private static final Pattern HARMLESS =
            Pattern.compile("(KHR|EXT)_(materials|texture|lights)_.*|KHR_mesh_quantization");

    private GltfDocument() {}

    private static ObjectMapper mapper() {
        ObjectMapper mapper = new ObjectMapper(JSON);
        // Values of a wrong type are missing afterwards; code that needs them reports it.
        JacksonUtils.configure(mapper, error -> {});
        return mapper;
    }

    static GlTF read(Path file, GlbFile parts) throws IOException {
        requireSmall(file, parts);
        GlTF gltf;
        try {
            gltf = MAPPER.readValue(parts.json(), GlTF.class);
        } catch (IOException | RuntimeException wrong) {
            throw new InputException(file + ": it is no glTF 2.0" + place(wrong) + "; export it again", wrong);
        }
        String version = gltf == null || gltf.getAsset() == null
                ? ""
                : String.valueOf(gltf.getAsset().getVersion());
        if (!version.startsWith("2.")) {
            throw new InputException(
                    file + ": it is glTF of version " + Quoted.of(version) + "; export it as glTF 2.0");
        }
        List<String> required = gltf.getExtensionsRequired() == null ? List.of() : gltf.getExtensionsRequired();
        for (String extension : required) {
            if (!HARMLESS.matcher(String.valueOf(extension)).matches()) {
                throw new InputException(file + ": it needs the extension " + Quoted.of(String.valueOf(extension))
                        + ", which is not known; export it without (uncompressed)");
            }
        }
        return gltf;
    }

    private static void requireSmall(Path file, GlbFile parts) throws IOException {
        try (JsonParser parser = JSON.createParser(parts.json())) {
            for (int values = 0; parser.nextToken() != null; values++) {
                if (values > MOST_VALUES) {
                    throw new InputException(file + ": its JSON has more than " + MOST_VALUES
                            + " values; export it with its numbers in a buffer");
                }
            }
        } catch (JsonProcessingException broken) {
            throw new InputException(file + ": no valid JSON" + place(broken) + "; export it again", broken);
        }
    }

    /** Where the parser stopped, as far as it says so; its own words are for programmers. */
    private static String place(Exception wrong) {
        return wrong instanceof JsonProcessingException json && json.getLocation() != null
                ? " in line " + json.getLocation().getLineNr() + ", column "
                        + json.getLocation().getColumnNr()
                : "";
    }
}
