package sunbeam.precompute.setting;

/** Names and complaints of a command line. */
public final class OptionWords implements Origin {
    public static final Origin INSTANCE = new OptionWords();

    private OptionWords() {}

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
