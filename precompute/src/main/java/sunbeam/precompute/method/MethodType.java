package sunbeam.precompute.method;

import java.util.List;
import java.util.function.Function;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * Kind of a method: a sentence for the manual, its settings, those that have a single value, and a function that creates the method and
 * refuses contradictions; each kind has one instance, in {@link Methods#ALL}.
 */
public record MethodType(
        String label, String help, List<Setting<?>> settings, Choices fixed, Function<Choices, Method> creation) {
    MethodType(String label, String help, List<Setting<?>> settings, Function<Choices, Method> creation) {
        this(label, help, settings, Choices.none(), creation);
    }

    public boolean has(Setting<?> setting) {
        return settings.contains(setting);
    }

    /** Creates the method; throws SettingException for contradictory choices, and ignores settings of other types. */
    public Method create(Choices choices) {
        Choices own = choices.only(settings);
        return own.located(() -> creation.apply(own));
    }

    @Override
    public String toString() {
        return label;
    }
}
