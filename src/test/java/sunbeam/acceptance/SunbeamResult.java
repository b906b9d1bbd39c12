package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

/**
 * Result of a finished start of the launcher.
 *
 * @param commandLine started command line, for messages
 * @param exitCode exit code as the shell sees it
 * @param stdout everything written to standard output, UTF-8
 * @param stderr everything written to standard error, UTF-8
 */
public record SunbeamResult(String commandLine, int exitCode, String stdout, String stderr) {
    public static final int USAGE = 2;
    public static final int UNUSABLE_INPUT = 4;
    public static final int NO_GRAPHICS = 5;
    public static final int CANNOT_WRITE = 6;
    public static final int OUTPUT_EXISTS = 8;
    public static final int INTERRUPTED = 130;

    public SunbeamResult ended(int code) {
        assertThat(exitCode).as(this::toString).isEqualTo(code);
        return this;
    }

    /** Returns standard error without the plan and lines of progress. */
    public String complaints() {
        return stderr.replaceFirst("(?m)^plan: .*\n", "").replaceAll("(?m)^sunbeam: .* \\d+% \\[.*\n", "");
    }

    /** Fails unless the program complained with this exit code, in one line with all of these words; a plan may precede it. */
    public void complains(int code, String... words) {
        ended(code);
        assertThat(stdout).as(this::toString).isEmpty();
        assertThat(complaints())
                .as(this::toString)
                .startsWith("sunbeam: ")
                .contains(words)
                .doesNotContain("Exception", "\tat ")
                .hasLineCount(1);
    }

    @Override
    public String toString() {
        return commandLine + "\nexit code " + exitCode + "\nstdout:\n" + stdout + "\nstderr:\n" + stderr;
    }
}
