package sunbeam.precompute.json;

import java.util.List;
import java.util.Map;

/** A JSON value with the line it begins on, from 1. */
public sealed interface JsonValue {
    /** Where it begins. */
    int line();

    /** A text. */
    record Text(String text, int line) implements JsonValue {}

    /** A number. */
    record Numeral(double value, int line) implements JsonValue {}

    /** true, false or null. */
    record Word(String word, int line) implements JsonValue {}

    /** A list. */
    record Sequence(List<JsonValue> values, int line) implements JsonValue {
        /** Copies the list. */
        public Sequence {
            values = List.copyOf(values);
        }
    }

    /**
     * An object.
     *
     * @param members in the file's order
     */
    record Members(Map<String, JsonValue> members, int line) implements JsonValue {}
}
