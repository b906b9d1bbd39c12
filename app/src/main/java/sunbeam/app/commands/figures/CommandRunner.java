package sunbeam.app.commands.figures;

import java.io.PrintWriter;

/** Runs a command line of this program. */
@FunctionalInterface
public interface CommandRunner {
    /** The exit code of a run with these streams. */
    int run(PrintWriter out, PrintWriter err, String... arguments);
}
