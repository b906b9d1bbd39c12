package sunbeam.precompute.setting;

import sunbeam.precompute.setting.Choices.Origin;
import sunbeam.precompute.setting.Setting.Sentence;
import sunbeam.precompute.text.Text;

/** Reports an invalid value of a setting. {@link Choices#located} adds the source of the value. */
public final class SettingException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Setting<?> about;
    private final transient Sentence problem;
    private final String value;
    private final Origin.Place place;

    /** Creates an exception without a source; the problem, texts and settings, continues "the setting and its value ...". */
    public SettingException(Setting<?> about, Object... problem) {
        this(about, Sentence.of(problem), Origin.PROGRAM, "", null);
    }

    /** Creates an exception without a source, for a value that may be a default. */
    public static <T> SettingException of(Setting<T> about, T value, Object... problem) {
        return new SettingException(
                about, Sentence.of(problem), Origin.PROGRAM, about.kind().format(value), null);
    }

    SettingException(Setting<?> about, Sentence problem, Origin origin, String value, Throwable cause) {
        super(Text.oneLine(origin.complaint(about, value, problem.in(origin))), cause);
        this.about = about;
        this.problem = problem;
        this.value = value;
        this.place = origin.place();
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

    public Origin.Place place() {
        return place;
    }
}
