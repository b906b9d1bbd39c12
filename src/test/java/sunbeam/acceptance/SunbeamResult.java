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
    public SunbeamResult ended(int code) {
        assertThat(exitCode).as(this::toString).isEqualTo(code);
        return this;
    }

    /** Returns standard error without the plan and lines of progress. */
    public String complaints() {
        return stderr.replaceFirst("(?m)^plan: .*\n", "").replaceAll("(?m)^sunbeam: .* \\d+% \\[.*\n", "");
    }

    @Override
    public String toString() {
        return commandLine + "\nexit code " + exitCode + "\nstdout:\n" + stdout + "\nstderr:\n" + stderr;
    }
}
