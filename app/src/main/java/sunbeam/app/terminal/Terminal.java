package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Map;

/**
 * The stream on which progress is shown.
 *
 * @param interactive whether it is a terminal, on which lines can be drawn over
 */
record Terminal(PrintStream stream, boolean interactive) {
    /** Width of the narrowest terminals in use. */
    static final int COLUMNS = 80;

    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    static Terminal ofStandardError(Map<String, String> variables) {
        boolean dumb = variables.getOrDefault("TERM", "dumb").equals("dumb");
        return new Terminal(System.err, !dumb && isErrorTerminal());
    }

    /** Asks Linux where standard error goes; Java knows only a console, which is input and output. */
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
