package sunbeam.precompute.setting;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Message of texts and {@link Setting}s, whose names depend on the source where they were chosen. */
public record Sentence(List<Object> parts) {
    public Sentence {
        parts = List.copyOf(parts);
        for (Object part : parts) {
            if (!(part instanceof String || part instanceof Setting<?>)) {
                throw new IllegalArgumentException(part + " is neither a text nor a setting");
            }
        }
    }

    public static Sentence of(Object... parts) {
        return new Sentence(Arrays.asList(parts));
    }

    /** Formats the message with a source's names. */
    public String in(Origin origin) {
        return parts.stream()
                .map(part -> part instanceof Setting<?> setting ? origin.name(setting) : part.toString())
                .collect(Collectors.joining());
    }
}
