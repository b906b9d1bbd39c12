package sunbeam.precompute.setting;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** Settings that somebody chose, with the places where they did. Immutable. Equal where the values are, wherever chosen. */
public final class Choices {
    private record Choice(Object value, Origin origin) {}

    private static final Choices NONE = new Choices(new LinkedHashMap<>(), Origin.PROGRAM);

    private final Map<Setting<?>, Choice> choices;
    private final Origin home;

    private Choices(Map<Setting<?>, Choice> choices, Origin home) {
        this.choices = choices;
        this.home = home;
    }

    /** Nothing chosen. */
    public static Choices none() {
        return NONE;
    }

    /**
     * Nothing chosen yet.
     *
     * @param home the place to whose reader complaints about what is not chosen are made
     */
    public static Choices at(Origin home) {
        return new Choices(new LinkedHashMap<>(), home);
    }

    /** The value of a setting, where it was chosen. */
    @SuppressWarnings("unchecked") // with() puts nothing else behind the setting
    public <T> Optional<T> find(Setting<T> setting) {
        return Optional.ofNullable(choices.get(setting)).map(choice -> (T) choice.value());
    }

    /** The value of a setting, or another where it was not chosen. */
    public <T> T get(Setting<T> setting, T otherwise) {
        return find(setting).orElse(otherwise);
    }

    /**
     * The value of a setting, or its standard value where it was not chosen.
     *
     * @throws java.util.NoSuchElementException for a setting without a standard value
     */
    public <T> T get(Setting<T> setting) {
        return find(setting).or(setting::standard).orElseThrow();
    }

    /** Whether a setting was chosen. */
    public boolean has(Setting<?> setting) {
        return choices.containsKey(setting);
    }

    /** The settings that were chosen, in the order in which they were. */
    public List<Setting<?>> chosen() {
        return List.copyOf(choices.keySet());
    }

    /** Where a setting was chosen; where it was not, the place whose choices these are. */
    public Origin origin(Setting<?> setting) {
        Choice choice = choices.get(setting);
        return choice == null ? home : choice.origin();
    }

    /**
     * The same with a value chosen at the place whose choices these are.
     *
     * @throws SettingException when it is not within the setting's limits
     */
    public <T> Choices with(Setting<T> setting, T value) {
        return with(setting, value, home);
    }

    /** As {@link #with(Setting, Object)}, chosen elsewhere. */
    public <T> Choices with(Setting<T> setting, T value, Origin origin) {
        T checked;
        try {
            checked = setting.kind().check(value);
        } catch (IllegalArgumentException wrong) {
            throw new SettingException(setting, Sentence.of(wrong.getMessage()), origin, "", wrong);
        }
        Map<Setting<?>, Choice> all = new LinkedHashMap<>(choices);
        all.put(setting, new Choice(checked, origin));
        return new Choices(all, home);
    }

    /**
     * The same with a value chosen as a text.
     *
     * @throws SettingException when the text is no value of the setting
     */
    public <T> Choices parsed(Setting<T> setting, String text, Origin origin) {
        try {
            return with(setting, setting.kind().parse(text), origin);
        } catch (IllegalArgumentException wrong) {
            throw new SettingException(setting, Sentence.of(wrong.getMessage()), origin, "", wrong);
        }
    }

    /** The same with a setting's standard value where it has one and none was chosen. */
    public <T> Choices orStandard(Setting<T> setting) {
        return has(setting) || setting.standard().isEmpty()
                ? this
                : with(setting, setting.standard().get(), Origin.PROGRAM);
    }

    /** The same without some. */
    public Choices without(Collection<? extends Setting<?>> settings) {
        Map<Setting<?>, Choice> rest = new LinkedHashMap<>(choices);
        settings.forEach(rest::remove);
        return new Choices(rest, home);
    }

    /** The same without one. */
    public Choices without(Setting<?> setting) {
        return without(List.of(setting));
    }

    /** Only those of some settings. */
    public Choices only(Collection<? extends Setting<?>> settings) {
        Map<Setting<?>, Choice> rest = new LinkedHashMap<>(choices);
        rest.keySet().removeIf(setting -> !settings.contains(setting));
        return new Choices(rest, home);
    }

    /** These, and what only others have chosen. The place is that of these. */
    public Choices over(Choices others) {
        Map<Setting<?>, Choice> all = new LinkedHashMap<>(others.choices);
        all.putAll(choices);
        return new Choices(all, home);
    }

    /** A complaint about a setting in the words of the place where it was chosen. */
    public SettingException complaint(Setting<?> setting, Object... problem) {
        return new SettingException(setting, Sentence.of(problem), origin(setting), written(setting), null);
    }

    /** The result of an action, whose complaints are made in the words of the places where these choices were made. */
    public <T> T located(Supplier<T> action) {
        try {
            return action.get();
        } catch (SettingException failure) {
            throw failure.place() == Origin.Place.PROGRAM ? located(failure) : failure;
        }
    }

    private SettingException located(SettingException failure) {
        Setting<?> setting = failure.about();
        String value = has(setting) ? written(setting) : failure.value();
        // What the program chose in a user's place is for the user to change.
        Origin place = origin(setting).place() == Origin.Place.PROGRAM ? home : origin(setting);
        return new SettingException(setting, failure.problem(), place, value, failure);
    }

    /** The value of a setting as it may be written, or empty where it was not chosen. */
    public String written(Setting<?> setting) {
        return find(setting).map(value -> format(setting, value)).orElse("");
    }

    @SuppressWarnings("unchecked") // the value was put there with this setting
    private static <T> String format(Setting<T> setting, Object value) {
        return setting.kind().format((T) value);
    }

    /** What was chosen, for metadata: "tolerance 0.001, coherence length 65 um". */
    public String describe() {
        return choices.keySet().stream()
                .map(setting -> setting.words(" ") + " " + written(setting))
                .collect(Collectors.joining(", "));
    }

    private Map<Setting<?>, Object> values() {
        Map<Setting<?>, Object> values = new LinkedHashMap<>();
        choices.forEach((setting, choice) -> values.put(setting, choice.value()));
        return values;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Choices others && others.values().equals(values());
    }

    @Override
    public int hashCode() {
        return values().hashCode();
    }

    @Override
    public String toString() {
        return describe();
    }
}
