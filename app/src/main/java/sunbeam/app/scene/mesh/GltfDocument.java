package sunbeam.app.scene.mesh;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.MapperFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.Material;
import de.javagl.jgltf.impl.v2.MaterialPbrMetallicRoughness;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/**
 * JSON of a glTF 2.0 file in jgltf's classes, whose own reader would open any URI and allocate any stated size, and the binary chunk of a
 * .glb file. Size, depth and number of values are limited; messages about a value name its path.
 */
record GltfDocument(GlTF gltf, ByteBuffer binary) {
    static final String MAGIC = "glTF";
    private static final int MAGIC_NUMBER = 0x46546C67;
    // The parsed tree of a longer text, with buffers as base64, would fill the heap.
    private static final int MOST_JSON_BYTES = 24 << 20;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;
    // "JSON" and "BIN\0" in little-endian ASCII.
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int MOST_VALUES = 1_000_000;
    private static final JsonFactory JSON = JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(64).build())
            .build();
    private static final ObjectMapper MAPPER = mapper();
    private static final Set<String> READ_PROPERTIES =
            Set.of("asset extensionsRequired scene scenes nodes meshes materials accessors bufferViews buffers"
                    .split(" ", -1));

    // An empty list is an error there, not an omission.
    private static final Set<String> TRANSFORMS = Set.of("matrix", "translation", "rotation", "scale");
    private static final Set<String> UNCHECKED = Set.of("extensions", "extras");
    /** Required extensions that are read or do not affect geometry. */
    private static final Pattern HARMLESS =
            Pattern.compile("(KHR|EXT)_(materials|texture|lights)_.*|KHR_mesh_quantization|KHR_node_visibility|"
                    + GltfInstances.EXTENSION);

    private static ObjectMapper mapper() {
        ObjectMapper mapper = JsonMapper.builder(JSON)
                .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES, DeserializationFeature.ACCEPT_FLOAT_AS_INT)
                .disable(MapperFeature.ALLOW_COERCION_OF_SCALARS)
                .build();
        ignore(mapper, Material.class, "occlusionTexture", "emissiveFactor", "alphaMode", "alphaCutoff", "doubleSided");
        ignore(mapper, MaterialPbrMetallicRoughness.class, "baseColorFactor", "metallicFactor", "roughnessFactor");
        return mapper;
    }

    private static void ignore(ObjectMapper mapper, Class<?> type, String... properties) {
        mapper.configOverride(type).setIgnorals(JsonIgnoreProperties.Value.forIgnoredProperties(properties));
    }

    static GltfDocument read(Path file) throws IOException {
        ByteBuffer all = map(file);
        if (all.limit() < HEADER_BYTES || all.getInt(0) != MAGIC_NUMBER) {
            return new GltfDocument(read(text(all, 0, all.limit())), ByteBuffer.allocate(0));
        }
        InputException.refuseIf(
                all.getInt(4) != 2,
                "it is glTF of version " + Integer.toUnsignedLong(all.getInt(4)) + "; export it as glTF 2.0");
        int first = HEADER_BYTES + CHUNK_HEADER_BYTES;
        int json = chunk(all, HEADER_BYTES, JSON_CHUNK, "JSON");
        int next = first + json;
        int binary = next + CHUNK_HEADER_BYTES > all.limit() ? 0 : chunk(all, next, BINARY_CHUNK, "binary");
        ByteBuffer content = slice(all, binary == 0 ? 0 : next + CHUNK_HEADER_BYTES, binary);
        return new GltfDocument(read(text(all, first, json)), content);
    }

    static ByteBuffer map(Path file) throws IOException {
        MeshSource.requireSize(file);
        try (FileChannel channel = FileChannel.open(file)) {
            return channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size()).order(ByteOrder.LITTLE_ENDIAN);
        }
    }

    static ByteBuffer slice(ByteBuffer buffer, int offset, int length) {
        return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static int chunk(ByteBuffer all, int at, int kind, String name) {
        if (at + CHUNK_HEADER_BYTES > all.limit() || all.getInt(at + 4) != kind) {
            throw new InputException("there is no " + name + " chunk at byte " + at + "; export it again");
        }
        int length = all.getInt(at);
        if (length < 0 || length > all.limit() - at - CHUNK_HEADER_BYTES) {
            throw new InputException("the " + name + " chunk has " + Integer.toUnsignedLong(length)
                    + " bytes, more than the file; copy or export it again");
        }
        return length;
    }

    private static byte[] text(ByteBuffer all, int offset, int length) {
        InputException.refuseIf(
                length > MOST_JSON_BYTES,
                "its JSON has " + length + " bytes; at most " + MOST_JSON_BYTES + " can be used, so export it as .glb");
        byte[] text = new byte[length];
        all.get(offset, text);
        return text;
    }

    private static GlTF read(byte[] json) throws IOException {
        JsonNode tree = tree(json);
        String version = tree.path("asset").path("version").asText();
        InputException.refuseIf(
                !version.startsWith("2."), "it is glTF of version " + Text.quoted(version) + "; export it as glTF 2.0");
        ((ObjectNode) tree).retain(READ_PROPERTIES);
        checkAndNormalize(JsonPointer.empty(), tree);
        GlTF gltf;
        try {
            gltf = MAPPER.treeToValue(tree, GlTF.class);
        } catch (JsonMappingException wrong) {
            JsonPointer path = JsonPointer.empty();
            for (JsonMappingException.Reference step : wrong.getPath()) {
                String field = step.getFieldName();
                path = field == null ? path.appendIndex(step.getIndex()) : path.appendProperty(field);
            }
            throw wrong(path, tree.at(path));
        }
        List<String> required = gltf.getExtensionsRequired() == null ? List.of() : gltf.getExtensionsRequired();
        for (String extension : required) {
            if (!HARMLESS.matcher(extension).matches()) {
                throw new InputException("it needs the extension " + Text.quoted(extension)
                        + ", which is not known; export it without (uncompressed)");
            }
        }
        return gltf;
    }

    private static JsonNode tree(byte[] json) throws IOException {
        try (JsonParser parser = JSON.createParser(json)) {
            for (int values = 0; parser.nextToken() != null; values++) {
                InputException.refuseIf(
                        values > MOST_VALUES,
                        "its JSON has more than " + MOST_VALUES + " values; export it with its numbers in a buffer");
            }
            return MAPPER.readTree(json);
        } catch (JsonProcessingException broken) {
            throw new InputException("no valid JSON" + place(broken) + "; export it again", broken);
        }
    }

    /** Refuses null and numbers beyond float32, drops empty lists, converts 2.0 to an integer; extensions and extras stay. */
    private static JsonNode checkAndNormalize(JsonPointer path, JsonNode value) {
        if (value.isNull() || (value.isNumber() && !Float.isFinite(value.floatValue()))) {
            throw wrong(path, value);
        }
        if (value instanceof ObjectNode object) {
            object.properties()
                    .removeIf(entry -> entry.getValue().isArray()
                            && entry.getValue().isEmpty()
                            && !TRANSFORMS.contains(entry.getKey()));
            for (Map.Entry<String, JsonNode> entry : object.properties()) {
                if (!UNCHECKED.contains(entry.getKey())) {
                    entry.setValue(checkAndNormalize(path.appendProperty(entry.getKey()), entry.getValue()));
                }
            }
        } else if (value instanceof ArrayNode array) {
            for (int i = 0; i < array.size(); i++) {
                array.set(i, checkAndNormalize(path.appendIndex(i), array.get(i)));
            }
        }
        return value.isDouble() && value.doubleValue() == value.intValue() ? IntNode.valueOf(value.intValue()) : value;
    }

    private static InputException wrong(JsonPointer path, JsonNode value) {
        return new InputException("it has " + Text.quoted(value.isTextual() ? value.textValue() : value.toString())
                + " at " + Text.quoted(path.toString())
                + ", which glTF 2.0 does not allow; repair it or export it again");
    }

    /** The parser's own message is for programmers. */
    private static String place(JsonProcessingException wrong) {
        var place = wrong.getLocation();
        return place == null ? "" : " in line " + place.getLineNr() + ", column " + place.getColumnNr();
    }
}
