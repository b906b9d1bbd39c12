package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

/**
 * Assertions on a failed run: an exit code and one line with the mistake and its remedy. The plan may precede the line if the mistake is
 * found later.
 */
public final class Complaint {
    public static final int USAGE = 2;
    public static final int UNUSABLE_INPUT = 4;
    public static final int NO_GRAPHICS = 5;
    public static final int CANNOT_WRITE = 6;
    public static final int OUTPUT_EXISTS = 8;
    public static final int INTERRUPTED = 130;

    private Complaint() {}

    /** Fails unless the program refused to overwrite a file, in one line that names it and the remedy. */
    public static void assertThatItExists(SunbeamResult result, String file) {
        assertThatIt(result, OUTPUT_EXISTS, "cannot write " + file + ": it exists; add --force");
    }

    /** Fails unless the program complained with this exit code, in one line with all of these words. */
    public static void assertThatIt(SunbeamResult result, int exitCode, String... words) {
        result.ended(exitCode);
        assertThat(result.stdout()).as("%s", result).isEmpty();
        assertThat(result.complaints())
                .as("%s", result)
                .startsWith("sunbeam: ")
                .contains(words)
                .doesNotContain("Exception", "\tat ")
                .hasLineCount(1);
    }
}
