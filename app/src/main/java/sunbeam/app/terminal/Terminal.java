package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Map;

/**
 * Stream on which progress is shown.
 *
 * @param interactive whether the stream is a terminal, on which a line can be overwritten
 */
record Terminal(PrintStream stream, boolean interactive) {
    /** Width of the narrowest terminals in use, in characters. */
    static final int COLUMNS = 80;

    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    static Terminal ofStandardError(Map<String, String> variables) {
        boolean dumb = variables.getOrDefault("TERM", "dumb").equals("dumb");
        return new Terminal(System.err, !dumb && isErrorTerminal());
    }

    /** Finds out from Linux whether standard error is a terminal; Java's {@code Console} tells this only of input and output together. */
    private static boolean isErrorTerminal() {
        try {
            String device = STANDARD_ERROR.toRealPath().toString();
            return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty") || device.equals("/dev/console");
        } catch (IOException unknown) {
            // Pipes and sockets have no path; other systems have no such file.
            return false;
        }
    }
}
