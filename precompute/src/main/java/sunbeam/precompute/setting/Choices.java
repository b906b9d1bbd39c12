package sunbeam.precompute.setting;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** Values of settings, each with the source where it was chosen. Immutable. Equality ignores the sources. */
public final class Choices {
    private record Choice(Object value, ChoiceOrigin origin) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Choice choice && choice.value.equals(value);
        }

        @Override
        public int hashCode() {
            return value.hashCode();
        }
    }

    private final Map<Setting<?>, Choice> choices;
    private final ChoiceOrigin home;

    private Choices(Map<Setting<?>, Choice> choices, ChoiceOrigin home) {
        this.choices = choices;
        this.home = home;
    }

    public static Choices none() {
        return at(ChoiceOrigin.PROGRAM);
    }

    /** Returns an empty set; its home is the source of values without another, and of complaints about settings that were not chosen. */
    public static Choices at(ChoiceOrigin home) {
        return new Choices(new LinkedHashMap<>(), home);
    }

    @SuppressWarnings("unchecked") // with() stores only values of the setting's type
    public <T> Optional<T> find(Setting<T> setting) {
        return Optional.ofNullable(choices.get(setting)).map(choice -> (T) choice.value());
    }

    public <T> T get(Setting<T> setting, T otherwise) {
        return find(setting).orElse(otherwise);
    }

    /** Returns the value of a setting, or its standard value, which must exist if it was not chosen. */
    public <T> T get(Setting<T> setting) {
        return find(setting).or(setting::standard).orElseThrow();
    }

    public boolean has(Setting<?> setting) {
        return choices.containsKey(setting);
    }

    public List<Setting<?>> chosen() {
        return List.copyOf(choices.keySet());
    }

    public ChoiceOrigin origin(Setting<?> setting) {
        Choice choice = choices.get(setting);
        return choice == null ? home : choice.origin();
    }

    /** Returns these choices with a value chosen at home; throws SettingException if it is not within the setting's limits. */
    public <T> Choices with(Setting<T> setting, T value) {
        return with(setting, value, home);
    }

    public <T> Choices with(Setting<T> setting, T value, ChoiceOrigin origin) {
        return with(setting, origin, () -> setting.kind().check(value));
    }

    /** Returns these choices with a value given as text; throws SettingException if it is none of the setting. */
    public <T> Choices parsed(Setting<T> setting, String text, ChoiceOrigin origin) {
        return with(setting, origin, () -> setting.kind().parse(text));
    }

    private <T> Choices with(Setting<T> setting, ChoiceOrigin origin, Supplier<T> value) {
        Map<Setting<?>, Choice> all = new LinkedHashMap<>(choices);
        try {
            all.put(setting, new Choice(value.get(), origin));
        } catch (IllegalArgumentException wrong) {
            throw new SettingException(setting, Sentence.of(wrong.getMessage()), origin, "", null, wrong);
        }
        return new Choices(all, home);
    }

    /** Returns these choices with a setting's standard value, if it has one and was not chosen. */
    public <T> Choices orStandard(Setting<T> setting) {
        return has(setting) || setting.standard().isEmpty()
                ? this
                : with(setting, setting.standard().get(), ChoiceOrigin.PROGRAM);
    }

    public Choices without(Collection<? extends Setting<?>> settings) {
        Map<Setting<?>, Choice> rest = new LinkedHashMap<>(choices);
        settings.forEach(rest::remove);
        return new Choices(rest, home);
    }

    public Choices without(Setting<?> setting) {
        return without(List.of(setting));
    }

    public Choices only(Collection<? extends Setting<?>> settings) {
        Map<Setting<?>, Choice> rest = new LinkedHashMap<>(choices);
        rest.keySet().removeIf(setting -> !settings.contains(setting));
        return new Choices(rest, home);
    }

    /** Returns these choices plus the others' choices of settings that are not chosen here. */
    public Choices over(Choices others) {
        Map<Setting<?>, Choice> all = new LinkedHashMap<>(others.choices);
        all.putAll(choices);
        return new Choices(all, home);
    }

    public SettingException complaint(Setting<?> setting, Object... problem) {
        return new SettingException(setting, Sentence.of(problem), origin(setting), written(setting), null, null);
    }

    /** Runs an action. A {@link SettingException} without a source gets the source of its setting. */
    public <T> T located(Supplier<T> action) {
        try {
            return action.get();
        } catch (SettingException failure) {
            if (failure.place() != ChoiceOrigin.Place.PROGRAM) {
                throw failure;
            }
            Setting<?> setting = failure.about();
            String value = has(setting) ? written(setting) : failure.value();
            // The user can change a value that the program chose at home.
            ChoiceOrigin place = origin(setting).place() == ChoiceOrigin.Place.PROGRAM ? home : origin(setting);
            throw new SettingException(
                    setting, failure.problem(), place, value, failure.excess().orElse(null), failure);
        }
    }

    public <T> String written(Setting<T> setting) {
        return find(setting).map(setting.kind()::format).orElse("");
    }

    /** Returns a description for metadata: "tolerance 0.001, coherence length 65 um". */
    public String describe() {
        return choices.keySet().stream()
                .map(setting -> setting.words(" ") + " " + written(setting))
                .collect(Collectors.joining(", "));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Choices others && others.choices.equals(choices);
    }

    @Override
    public int hashCode() {
        return choices.hashCode();
    }

    @Override
    public String toString() {
        return describe();
    }
}
