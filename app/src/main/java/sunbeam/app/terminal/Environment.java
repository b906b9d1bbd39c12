package sunbeam.app.terminal;

import java.nio.file.Path;
import java.util.Map;

/**
 * What the program takes from the process and its user.
 *
 * @param variables environment variables
 * @param home the user's home folder
 * @param progress shows the progress of all tasks
 */
public record Environment(Map<String, String> variables, Path home, ProgressDisplay progress) {
    /** Set to 1, prints stack traces as {@code --debug} does. */
    public static final String DEBUG_VARIABLE = "SUNBEAM_DEBUG";

    public Environment {
        variables = Map.copyOf(variables);
    }

    /** Shows progress on standard error. */
    public Environment(Map<String, String> variables, Path home) {
        this(variables, home, ProgressDisplay.ofStandardError(variables));
    }

    /** Returns the environment of this process. */
    public static Environment ofProcess() {
        return new Environment(System.getenv(), Path.of(System.getProperty("user.home")));
    }

    /** Returns the variable's value, or an empty string if it is not set. */
    public String variable(String name) {
        return variables.getOrDefault(name, "");
    }

    /** Whether stack traces are printed. */
    public boolean debug() {
        return variable(DEBUG_VARIABLE).equals("1");
    }
}
