package sunbeam.precompute.setting;

import java.util.List;
import java.util.stream.Collectors;

/** Message of texts and {@link Setting}s, whose names depend on the source where they were chosen. */
public record Sentence(List<Object> parts) {
    public static Sentence of(Object... parts) {
        return new Sentence(List.of(parts));
    }

    public String in(ChoiceOrigin origin) {
        return parts.stream()
                .map(part -> part instanceof Setting<?> setting ? origin.name(setting) : part.toString())
                .collect(Collectors.joining());
    }
}
