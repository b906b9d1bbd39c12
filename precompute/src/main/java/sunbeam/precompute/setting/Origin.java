package sunbeam.precompute.setting;

/** Source of a setting's value (an option, a file, a control). It formats complaints about the value. */
public interface Origin {
    /** Kinds of sources. */
    enum Place {
        /** An option of the command line. */
        OPTION,
        /** A key of a file. */
        FILE,
        /** A control of a window. */
        CONTROL,
        /** The program itself. */
        PROGRAM
    }

    /** Returns the kind of source. */
    Place place();

    /** Returns the name of a setting at this source, for use in a sentence: {@code --terms}, {@code terms}. */
    String name(Setting<?> setting);

    /**
     * Returns a complaint in one line.
     *
     * @param setting setting of the complaint
     * @param value the value as written at the source, or empty
     * @param problem fault and remedy, continuing "the value ..."
     */
    String complaint(Setting<?> setting, String value, String problem);

    /** Source of values that the program chose; its names of settings are the words of their keys. */
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
