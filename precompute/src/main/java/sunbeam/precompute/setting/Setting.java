package sunbeam.precompute.setting;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * One thing that a user may choose, declared once.
 *
 * @param key its name, such as {@code coherenceLength}; what options and controls call it derives from that
 * @param fileKey its name in files, mostly the same
 * @param kind its values, their unit and limits
 * @param help what it does, in a few sentences for a manual, which adds the standard value
 * @param standard what holds where nothing is chosen, where that is always the same
 * @param <T> of a value
 */
public record Setting<T>(String key, String fileKey, ValueKind<T> kind, Sentence help, Optional<T> standard) {
    private static final Pattern KEY = Pattern.compile("[a-z]+([A-Z][a-z]*)*");
    private static final Pattern CAPITAL = Pattern.compile("([A-Z])");

    public Setting {
        if (!KEY.matcher(key).matches() || !KEY.matcher(fileKey).matches()) {
            throw new IllegalArgumentException("key " + key + " or " + fileKey + " is not written likeThis");
        }
        standard = standard.map(kind::check);
    }

    /** A setting without a standard value, which files call as all others do. */
    public Setting(String key, ValueKind<T> kind, Object... help) {
        this(key, key, kind, Sentence.of(help), Optional.empty());
    }

    /** The same with a value that holds where nothing is chosen. */
    public Setting<T> withStandard(T value) {
        return new Setting<>(key, fileKey, kind, help, Optional.of(value));
    }

    /** The same setting, which files call otherwise. */
    public Setting<T> inFiles(String name) {
        return new Setting<>(key, name, kind, help, standard);
    }

    /** The standard value as it may be written, where there is one. */
    public Optional<String> writtenStandard() {
        return standard.map(kind::format);
    }

    /** The key's words in lower case, with something between them: {@code coherence-length}, {@code coherence length}. */
    public String words(String between) {
        return CAPITAL.matcher(key).replaceAll(between + "$1").toLowerCase(Locale.ROOT);
    }

    /** By key: there is one setting of a key. */
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
