package sunbeam.precompute.setting;

import sunbeam.precompute.text.Quoted;

/**
 * Thrown if the value of a setting is invalid, alone or together with others. {@link Choices#located} adds the source of the value to an
 * exception without one.
 */
public final class SettingException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Setting<?> about;
    private final transient Sentence problem;
    private final String value;
    private final Origin.Place place;

    /**
     * Creates an exception without a source.
     *
     * @param about the setting
     * @param problem fault and remedy as texts and settings; continues "the setting and its value ..."
     */
    public SettingException(Setting<?> about, Object... problem) {
        this(about, Sentence.of(problem), Origin.PROGRAM, "", null);
    }

    /**
     * Creates an exception without a source, for a value that may be a default.
     *
     * @param value the value
     */
    public static <T> SettingException of(Setting<T> about, T value, Object... problem) {
        return new SettingException(
                about, Sentence.of(problem), Origin.PROGRAM, about.kind().format(value), null);
    }

    SettingException(Setting<?> about, Sentence problem, Origin origin, String value, Throwable cause) {
        super(Quoted.oneLine(origin.complaint(about, value, problem.in(origin))), cause);
        this.about = about;
        this.problem = problem;
        this.value = value;
        this.place = origin.place();
    }

    /** Returns the setting. */
    public Setting<?> about() {
        return about;
    }

    /** Returns fault and remedy. */
    public Sentence problem() {
        return problem;
    }

    /** Returns the value as text; empty if unknown. */
    String value() {
        return value;
    }

    /** Returns the kind of source; {@code PROGRAM} if unknown. */
    public Origin.Place place() {
        return place;
    }
}
