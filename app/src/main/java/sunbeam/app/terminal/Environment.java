package sunbeam.app.terminal;

import java.nio.file.Path;
import java.util.Map;

/**
 * What the process inherits from its user.
 *
 * @param variables environment variables
 * @param home the user's home folder
 */
public record Environment(Map<String, String> variables, Path home) {
    /** Set to 1, prints stack traces as {@code --debug} does. */
    public static final String DEBUG_VARIABLE = "SUNBEAM_DEBUG";

    public Environment {
        variables = Map.copyOf(variables);
    }

    /** The environment of this process. */
    public static Environment ofProcess() {
        return new Environment(System.getenv(), Path.of(System.getProperty("user.home")));
    }

    /** The variable's value, or an empty string when it is not set. */
    public String variable(String name) {
        return variables.getOrDefault(name, "");
    }

    /** Whether stack traces are asked for. */
    public boolean debug() {
        return variable(DEBUG_VARIABLE).equals("1");
    }
}
