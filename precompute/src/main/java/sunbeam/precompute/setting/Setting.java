package sunbeam.precompute.setting;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Declaration of a user's setting.
 *
 * @param key name, such as {@code coherenceLength}, from which names of options and controls derive
 * @param help description in the manual, without the standard value
 * @param standard default value, if it does not depend on other settings
 * @param <T> type of values
 */
public record Setting<T>(String key, String fileKey, ValueKind<T> kind, Sentence help, Optional<T> standard) {
    private static final Pattern CAPITAL = Pattern.compile("([A-Z])");

    public Setting {
        standard = standard.map(kind::check);
    }

    /** Creates a setting without a standard value, whose name in files is its key. */
    public Setting(String key, ValueKind<T> kind, Object... help) {
        this(key, key, kind, Sentence.of(help), Optional.empty());
    }

    public Setting<T> withStandard(T value) {
        return new Setting<>(key, fileKey, kind, help, Optional.of(value));
    }

    public Setting<T> inFiles(String name) {
        return new Setting<>(key, name, kind, help, standard);
    }

    @SafeVarargs
    public static List<Setting<?>> union(List<Setting<?>>... lists) {
        Set<Setting<?>> all = new LinkedHashSet<>();
        for (List<Setting<?>> list : lists) {
            all.addAll(list);
        }
        return List.copyOf(all);
    }

    public Optional<String> writtenStandard() {
        return standard.map(kind::format);
    }

    /** Returns the key's words in lower case, with a separator: {@code coherence-length}, {@code coherence length}. */
    public String words(String between) {
        return CAPITAL.matcher(key).replaceAll(between + "$1").toLowerCase(Locale.ROOT);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Setting<?> setting && setting.key.equals(key);
    }

    @Override
    public int hashCode() {
        return key.hashCode();
    }

    @Override
    public String toString() {
        return key;
    }
}
