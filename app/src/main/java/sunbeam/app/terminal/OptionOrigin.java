package sunbeam.app.terminal;

import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.Setting;

/** Choices made by options of the command line: {@code coherenceLength} is {@code --coherence-length}. */
public enum OptionOrigin implements Origin {
    /** The only command line that there is. */
    INSTANCE;

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
        return (name(setting) + " " + value).strip() + " " + problem;
    }
}
