package sunbeam.precompute.setting;

import java.util.Optional;
import sunbeam.precompute.text.Text;

/** Reports an invalid value of a setting. {@link Choices#located} adds the source of the value. */
public final class SettingException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Setting<?> about;
    private final transient Sentence problem;
    private final String value;
    private final ChoiceOrigin.Place place;
    private final transient Excess excess;

    /** Creates an exception without a source; the problem, texts and settings, continues "the setting and its value ...". */
    public SettingException(Setting<?> about, Object... problem) {
        this(about, Sentence.of(problem), ChoiceOrigin.PROGRAM, "", null, null);
    }

    /** Creates an exception without a source, for a value that may be a default. */
    public static <T> SettingException of(Setting<T> about, T value, Object... problem) {
        return new SettingException(
                about, Sentence.of(problem), ChoiceOrigin.PROGRAM, about.kind().format(value), null, null);
    }

    SettingException(
            Setting<?> about, Sentence problem, ChoiceOrigin origin, String value, Excess excess, Throwable cause) {
        super(Text.oneLine(origin.complaint(about, value, problem.in(origin))), cause);
        this.about = about;
        this.problem = problem;
        this.value = value;
        this.place = origin.place();
        this.excess = excess;
    }

    /** Returns this exception, which has no source yet, as the consequence of a resource that does not suffice. */
    public SettingException because(Excess limit) {
        return new SettingException(about, problem, ChoiceOrigin.PROGRAM, value, limit, this);
    }

    /** Returns the resource that the value exceeds; empty if the value is wrong on any machine. */
    public Optional<Excess> excess() {
        return Optional.ofNullable(excess);
    }

    public Setting<?> about() {
        return about;
    }

    public Sentence problem() {
        return problem;
    }

    String value() {
        return value;
    }

    public ChoiceOrigin.Place place() {
        return place;
    }
}
