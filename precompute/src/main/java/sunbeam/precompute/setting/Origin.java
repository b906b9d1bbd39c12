package sunbeam.precompute.setting;

/** Source of a setting's value (an option, a file, a control). It formats complaints about the value. */
public interface Origin {
    enum Place {
        OPTION,
        FILE,
        CONTROL,
        PROGRAM
    }

    Place place();

    /** Returns the name of a setting at this source, for use in a sentence: {@code --terms}, {@code terms}. */
    String name(Setting<?> setting);

    /** Returns a complaint in one line; the value is as written at the source, or empty, and the problem continues "the value ...". */
    String complaint(Setting<?> setting, String value, String problem);

    /** The program itself; its names of settings are the words of their keys. */
    Origin PROGRAM = new Origin() {
        @Override
        public Place place() {
            return Place.PROGRAM;
        }

        @Override
        public String name(Setting<?> setting) {
            return setting.words(" ");
        }

        @Override
        public String complaint(Setting<?> setting, String value, String problem) {
            return (name(setting) + " " + value).strip() + " " + problem;
        }
    };
}
