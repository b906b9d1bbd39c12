package sunbeam.precompute.method;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * A method before anything of it is chosen. One object each, in {@link Methods#ALL}.
 *
 * @param label lower-case name in all places: {@code full}
 * @param help what it is, one sentence for a manual
 * @param settings what may be chosen
 * @param fixed settings that have one value only
 * @param creation from choices of these settings; complains of what does not fit together
 */
public record MethodType(
        String label, String help, List<Setting<?>> settings, Choices fixed, Function<Choices, Method> creation) {
    public MethodType {
        settings = List.copyOf(settings);
    }

    MethodType(String label, String help, List<Setting<?>> settings, Function<Choices, Method> creation) {
        this(label, help, settings, Choices.none(), creation);
    }

    /** The same for which a setting has one value only, which may be said but not changed. */
    <T> MethodType fixing(Setting<T> setting, T value) {
        return new MethodType(label, help, settings, fixed.with(setting, value), creation);
    }

    /** Whether a setting may be chosen. */
    public boolean has(Setting<?> setting) {
        return settings.contains(setting);
    }

    /** The only value that a setting has with this method, where it has no choice. */
    Optional<String> fixed(Setting<?> setting) {
        return fixed.has(setting) ? Optional.of(fixed.written(setting)) : Optional.empty();
    }

    /**
     * The method.
     *
     * @param choices others than those of this type's settings are not looked at
     * @throws sunbeam.precompute.setting.SettingException in the words of the places where choices that do not fit were made
     */
    public Method create(Choices choices) {
        Choices own = choices.only(settings);
        return own.located(() -> creation.apply(own));
    }

    @Override
    public String toString() {
        return label;
    }
}
