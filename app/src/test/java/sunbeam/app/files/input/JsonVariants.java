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
        ObjectMapper mapper = new ObjectMapper();
        JsonNode good = mapper.readTree(json);
        List<String> variants = new ArrayList<>();
        for (JsonNode value : VALUES) {
            JsonNode copy = good.deepCopy();
            for (int place = 0; replace(copy, value, new int[] {place}); place++) {
                variants.add(mapper.writeValueAsString(copy));
                copy = good.deepCopy();
            }
        }
        return variants;
    }

    /** Replaces the value of a number, counted down on the way; returns whether there are as many. */
    private static boolean replace(JsonNode node, JsonNode value, int[] left) {
        if (node instanceof ObjectNode object) {
            for (Map.Entry<String, JsonNode> entry : List.copyOf(object.properties())) {
                if (left[0]-- == 0) {
                    object.set(entry.getKey(), value);
                    return true;
                }
                if (replace(entry.getValue(), value, left)) {
                    return true;
                }
            }
        } else if (node instanceof ArrayNode array) {
            for (int i = 0; i < array.size(); i++) {
                if (left[0]-- == 0) {
                    array.set(i, value);
                    return true;
                }
                if (replace(array.get(i), value, left)) {
                    return true;
                }
            }
        }
        return false;
    }
}
