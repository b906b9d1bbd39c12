package sunbeam.app.cli.options;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.terminal.Environment;

/** A command, and where it says what it did. Returns its exit code. */
public abstract class ReportingCommand implements Callable<Integer> {
    @Spec
    private CommandSpec specification;

    @ParentCommand
    private Root root;

    /** The command under which all others stand. */
    public interface Root {
        Environment environment();
    }

    protected final Environment environment() {
        return root.environment();
    }

    /** Standard error, for plans, warnings and notes. */
    protected final PrintWriter err() {
        return specification.commandLine().getErr();
    }

    /**
     * Where the command says what it did: beside what it writes, never in its midst.
     *
     * @param targets the files that it writes; null counts for none
     */
    protected final PrintWriter out(Path... targets) {
        for (Path target : targets) {
            if (StandardOutput.isMeant(target)) {
                return err();
            }
        }
        return specification.commandLine().getOut();
    }

    /** Whether the command line names no option. */
    protected final boolean isPlain() {
        return specification.commandLine().getParseResult().matchedOptions().isEmpty();
    }
}
