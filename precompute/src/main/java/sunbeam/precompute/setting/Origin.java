package sunbeam.precompute.setting;

/** Where a value was chosen, in whose words a complaint about it is made. */
public interface Origin {
    /** Kinds of places. */
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

    /** The kind of place. */
    Place place();

    /** What this place calls a setting, within a sentence: {@code --terms}, {@code terms}. */
    String name(Setting<?> setting);

    /**
     * A complaint in one line.
     *
     * @param setting that it is about
     * @param value as it was written there, or empty where it was not
     * @param problem what is wrong with it and what helps, continuing "the value ..."
     */
    String complaint(Setting<?> setting, String value, String problem);

    /** The program's own choice: names are the keys' words. */
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
