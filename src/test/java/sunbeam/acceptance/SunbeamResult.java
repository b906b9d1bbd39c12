package sunbeam.acceptance;

/**
 * What a finished start of the launcher left.
 *
 * @param commandLine what was started, for messages
 * @param exitCode as the shell sees it
 * @param stdout everything written to standard output, UTF-8
 * @param stderr everything written to standard error, UTF-8
 */
public record SunbeamResult(String commandLine, int exitCode, String stdout, String stderr) {
    /** What stands on standard error besides the plan, and what a slow machine is told of progress. */
    public String complaints() {
        return stderr.replaceFirst("(?m)^plan: .*\n", "").replaceAll("(?m)^sunbeam: .* \\d+% \\[.*\n", "");
    }

    /** The whole story, for the message of a failed assertion. */
    @Override
    public String toString() {
        return commandLine + "\nexit code " + exitCode + "\nstdout:\n" + stdout + "\nstderr:\n" + stderr;
    }
}
