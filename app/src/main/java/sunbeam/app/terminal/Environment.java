package sunbeam.app.terminal;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;

/** Environment of the process: variables, home folder and progress display. */
public record Environment(Map<String, String> variables, Path home, ProgressDisplay progress) {
    /** Variable that, set to 1, makes the program print stack traces as {@code --debug} does. */
    public static final String DEBUG_VARIABLE = "SUNBEAM_DEBUG";

    public Environment(Map<String, String> variables, Path home) {
        this(variables, home, ProgressDisplay.ofStandardError(variables));
    }

    public static Environment ofProcess() {
        return new Environment(System.getenv(), Path.of(System.getProperty("user.home")));
    }

    public String variable(String name) {
        return variables.getOrDefault(name, "");
    }

    public boolean debug() {
        return variable(DEBUG_VARIABLE).equals("1");
    }

    /** Returns the text of a resource beside a class. */
    public static String resource(Class<?> owner, String name) {
        try (InputStream stream = owner.getResourceAsStream(name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException failure) {
            throw new UncheckedIOException(name, failure);
        }
    }

    public static String version() {
        Properties properties = new Properties();
        try {
            properties.load(new StringReader(resource(Environment.class, "version.properties")));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return properties.getProperty("version");
    }
}
