package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.terminal.Environment;

/** Test that runs command lines in this process, with a new folder as home and no environment variables. */
public abstract class CommandLineFixture {
    @TempDir
    protected Path folder;

    /** Standard output of all runs. */
    protected final StringWriter out = new StringWriter();

    /** Standard error of all runs. */
    protected final StringWriter err = new StringWriter();

    /** Runs a command line and returns its exit code. */
    protected final int sunbeam(String... arguments) {
        Environment environment = new Environment(Map.of(), folder);
        return new Sunbeam(environment, new PrintWriter(out), new PrintWriter(err)).run(arguments);
    }

    protected final int sunbeam(String[] first, String... more) {
        return sunbeam(with(first, more));
    }

    protected static String[] with(String[] first, String... more) {
        return Stream.concat(Arrays.stream(first), Arrays.stream(more)).toArray(String[]::new);
    }

    /** Writes a scan as text: a header, then a line for each row. */
    protected final Path scan(String name, String header, int columns, int rows, DoubleBinaryOperator heights)
            throws IOException {
        StringBuilder text = new StringBuilder(header);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                text.append(heights.applyAsDouble(column, row)).append(column < columns - 1 ? "\t" : "\n");
            }
        }
        return Files.writeString(folder.resolve(name), text);
    }

    protected final JsonNode readJson(String name) throws IOException {
        return new ObjectMapper().readTree(folder.resolve(name).toFile());
    }

    /** Asserts that an exit code is 0; a failure shows standard error. */
    protected final void assertSuccess(int exitCode) {
        assertThat(exitCode).as("%s", err).isZero();
    }

    protected final void forgetOutput() {
        out.getBuffer().setLength(0);
        err.getBuffer().setLength(0);
    }
}
