package sunbeam.precompute.setting;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * One thing that a user may choose, declared once.
 *
 * @param key its name in files, such as {@code coherenceLength}; what other places call it derives from that
 * @param kind its values, their unit and limits
 * @param help what it does, in one or two sentences for a manual; the standard value is added to it
 * @param standard what holds where nothing is chosen, where that is always the same
 * @param <T> of a value
 */
public record Setting<T>(String key, ValueKind<T> kind, Sentence help, Optional<T> standard) {
    private static final Pattern KEY = Pattern.compile("[a-z]+([A-Z][a-z]*)*");
    private static final Pattern CAPITAL = Pattern.compile("([A-Z])");

    public Setting {
        if (!KEY.matcher(key).matches()) {
            throw new IllegalArgumentException("key " + key + " is not written likeThis");
        }
        standard = standard.map(kind::check);
    }

    /** A setting without a standard value. */
    public Setting(String key, ValueKind<T> kind, Object... help) {
        this(key, kind, Sentence.of(help), Optional.empty());
    }

    /** The same with a value that holds where nothing is chosen. */
    public Setting<T> withStandard(T value) {
        return new Setting<>(key, kind, help, Optional.of(value));
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
