package sunbeam.precompute.setting;

import java.util.function.Function;

/** Source of a setting's value (an option, a file, a control). It formats complaints about the value. */
public interface ChoiceOrigin {
    enum Place {
        OPTION,
        FILE,
        CONTROL,
        PROGRAM
    }

    Place place();

    /** Returns the name of a setting at this source, for use in a sentence: {@code --terms}, {@code terms}. */
    String name(Setting<?> setting);

    /** Returns an error message in one line; the problem continues "the value ...", such as "must be at least 1". */
    default String complaint(Setting<?> setting, String value, String problem) {
        return (name(setting) + " " + value).strip() + " " + problem;
    }

    /** The program itself. It names a setting by the words of its key, such as {@code coherence length}. */
    ChoiceOrigin PROGRAM = of(Place.PROGRAM, setting -> setting.words(" "));

    static ChoiceOrigin of(Place place, Function<Setting<?>, String> names) {
        record Named(Place place, Function<Setting<?>, String> names) implements ChoiceOrigin {
            @Override
            public String name(Setting<?> setting) {
                return names.apply(setting);
            }
        }
        return new Named(place, names);
    }
}
