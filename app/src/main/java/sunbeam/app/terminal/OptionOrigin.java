package sunbeam.app.terminal;

import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.Setting;

/** ChoiceOrigin of choices made on the command line: the setting {@code coherenceLength} is the option {@code --coherence-length}. */
public enum OptionOrigin implements ChoiceOrigin {
    INSTANCE,
    ARGUMENT;

    @Override
    public Place place() {
        return Place.OPTION;
    }

    @Override
    public String name(Setting<?> setting) {
        return "--" + setting.words("-");
    }

    @Override
    public String complaint(Setting<?> setting, String value, String problem) {
        return this == ARGUMENT && !value.isEmpty()
                ? value + " " + problem
                : ChoiceOrigin.super.complaint(setting, value, problem);
    }
}
