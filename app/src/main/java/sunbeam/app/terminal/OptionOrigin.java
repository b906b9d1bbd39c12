package sunbeam.app.terminal;

import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.Setting;

/** Choices made by options of the command line: {@code coherenceLength} is {@code --coherence-length}. */
public enum OptionOrigin implements Origin {
    /** By the option. */
    INSTANCE,
    /** By an argument that stands where no option is. */
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
        return this == ARGUMENT ? value + " " + problem : (name(setting) + " " + value).strip() + " " + problem;
    }
}
