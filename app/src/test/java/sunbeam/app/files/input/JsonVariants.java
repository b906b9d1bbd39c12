package sunbeam.app.files.input;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** Variants of a document: each has one value replaced by null or another kind of value. */
public final class JsonVariants {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final List<JsonNode> VALUES = List.of(
            NODES.nullNode(),
            NODES.numberNode(1),
            NODES.numberNode(-1.5e300),
            NODES.textNode("x"),
            NODES.booleanNode(true),
            NODES.arrayNode(),
            NODES.arrayNode().addNull(),
            NODES.objectNode());

    private JsonVariants() {}

    public static List<String> of(String json) throws IOException {
        JsonNode root = new ObjectMapper().readTree(json);
        List<String> variants = new ArrayList<>();
        vary(root, root, variants);
        return variants;
    }

    private static void vary(JsonNode root, JsonNode node, List<String> variants) {
        if (node instanceof ObjectNode object) {
            for (Map.Entry<String, JsonNode> entry : List.copyOf(object.properties())) {
                vary(root, entry.getValue(), value -> object.set(entry.getKey(), value), variants);
            }
        } else if (node instanceof ArrayNode array) {
            for (int i = 0; i < array.size(); i++) {
                int at = i;
                vary(root, array.get(i), value -> array.set(at, value), variants);
            }
        }
    }

    private static void vary(JsonNode root, JsonNode good, Consumer<JsonNode> place, List<String> variants) {
        for (JsonNode value : VALUES) {
            place.accept(value);
            variants.add(root.toString());
        }
        place.accept(good);
        vary(root, good, variants);
    }
}
