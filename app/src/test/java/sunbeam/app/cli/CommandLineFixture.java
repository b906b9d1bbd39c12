package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Map;
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

    /** Asserts that an exit code is 0; a failure shows standard error. */
    protected final void assertSuccess(int exitCode) {
        assertThat(exitCode).as("%s", err).isZero();
    }

    protected final void forgetOutput() {
        out.getBuffer().setLength(0);
        err.getBuffer().setLength(0);
    }
}
