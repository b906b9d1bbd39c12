package sunbeam.precompute.setting;

import sunbeam.precompute.text.Quoted;

/**
 * A choice that cannot be used, alone or with others. Thrown where it is noticed, without a place; {@link
 * Choices#located} adds the place where the choice was made.
 */
public final class SettingException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Setting<?> about;
    private final transient Sentence problem;
    private final String value;
    private final Origin.Place place;

    /**
     * A complaint that does not know yet where the choice was made.
     *
     * @param about the setting
     * @param problem what is wrong and what helps, texts and settings; continues "the setting and its value ..."
     */
    public SettingException(Setting<?> about, Object... problem) {
        this(about, Sentence.of(problem), Origin.PROGRAM, "", null);
    }

    /**
     * The same where the value may not have been chosen, but is what holds.
     *
     * @param value as it may be written
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

    /** The setting. */
    public Setting<?> about() {
        return about;
    }

    /** What is wrong and what helps. */
    public Sentence problem() {
        return problem;
    }

    /** Its value as it may be written; empty where nobody has said it. */
    String value() {
        return value;
    }

    /** Where the choice was made; {@code PROGRAM} where nobody has said so. */
    public Origin.Place place() {
        return place;
    }
}
