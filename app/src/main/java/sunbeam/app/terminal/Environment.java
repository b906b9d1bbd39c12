package sunbeam.app.terminal;

import java.nio.file.Path;
import java.util.Map;

/** Environment of the process: variables, home folder and progress display. */
public record Environment(Map<String, String> variables, Path home, ProgressDisplay progress) {
    /** Variable that, set to 1, makes the program print stack traces as {@code --debug} does. */
    public static final String DEBUG_VARIABLE = "SUNBEAM_DEBUG";

    public Environment {
        variables = Map.copyOf(variables);
    }

    /** Creates an environment that shows progress on standard error. */
    public Environment(Map<String, String> variables, Path home) {
        this(variables, home, ProgressDisplay.ofStandardError(variables));
    }

    public static Environment ofProcess() {
        return new Environment(System.getenv(), Path.of(System.getProperty("user.home")));
    }

    /** Returns the variable's value; empty if it is not set. */
    public String variable(String name) {
        return variables.getOrDefault(name, "");
    }

    /** True if {@link #DEBUG_VARIABLE} is set, so that stack traces are printed. */
    public boolean debug() {
        return variable(DEBUG_VARIABLE).equals("1");
    }
}
