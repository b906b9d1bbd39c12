package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

/** What a user's mistake must end in: an exit code of its kind and one line that says what and how to mend it. */
final class Complaint {
    static final int USAGE = 2;
    static final int UNUSABLE_INPUT = 4;
    static final int NO_GRAPHICS = 5;
    static final int CANNOT_WRITE = 6;
    static final int INTERRUPTED = 130;

    private Complaint() {}

    /** Fails unless the program complained with this exit code, in one line with all of these words. */
    static void assertThatIt(SunbeamResult result, int exitCode, String... words) {
        assertThat(result.exitCode()).as("%s", result).isEqualTo(exitCode);
        assertThat(result.stdout()).as("%s", result).isEmpty();
        assertThat(result.stderr())
                .as("%s", result)
                .startsWith("sunbeam: ")
                .contains(words)
                .doesNotContain("Exception", "\tat ")
                .hasLineCount(1);
    }
}
