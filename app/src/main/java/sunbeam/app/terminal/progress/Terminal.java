package sunbeam.app.terminal.progress;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Map;

/** Where progress is drawn, and whether a person looks at it, so that lines may be drawn over. */
record Terminal(PrintStream stream, boolean interactive) {
    /** Of the narrowest in use. */
    static final int COLUMNS = 80;

    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    static Terminal ofStandardError(Map<String, String> variables) {
        boolean dumb = variables.getOrDefault("TERM", "dumb").equals("dumb");
        return new Terminal(System.err, !dumb && isErrorTerminal());
    }

    /** Java knows only of a console, which is input and output: Linux tells where standard error goes. */
    private static boolean isErrorTerminal() {
        try {
            String device = STANDARD_ERROR.toRealPath().toString();
            return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty") || device.equals("/dev/console");
        } catch (IOException unknown) {
            // Pipes and sockets have no path; other systems do not tell, so nothing is drawn there.
            return false;
        }
    }
}
