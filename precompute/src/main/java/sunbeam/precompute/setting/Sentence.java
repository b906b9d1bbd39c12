package sunbeam.precompute.setting;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A sentence that speaks of settings without knowing what the reader calls them.
 *
 * @param parts texts and {@link Setting}s
 */
public record Sentence(List<Object> parts) {
    public Sentence {
        parts = List.copyOf(parts);
        for (Object part : parts) {
            if (!(part instanceof String || part instanceof Setting<?>)) {
                throw new IllegalArgumentException(part + " is neither a text nor a setting");
            }
        }
    }

    /** A sentence of texts and settings in their order. */
    public static Sentence of(Object... parts) {
        return new Sentence(Arrays.asList(parts));
    }

    /** In the words of a place. */
    public String in(Origin origin) {
        return parts.stream()
                .map(part -> part instanceof Setting<?> setting ? origin.name(setting) : part.toString())
                .collect(Collectors.joining());
    }
}
