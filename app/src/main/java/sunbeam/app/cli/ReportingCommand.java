package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.terminal.Environment;

/** Base class of commands, with the streams for their reports. {@link #call} returns the exit code. */
public abstract class ReportingCommand implements Callable<Integer> {
    @Spec
    private CommandSpec specification;

    @ParentCommand
    private Supplier<Environment> root;

    protected final Environment environment() {
        return root.get();
    }

    /** Returns standard error, for plans, warnings and notes. */
    protected final PrintWriter err() {
        return specification.commandLine().getErr();
    }

    /** Returns standard output for the report, or standard error if one of these files, which may be null, is standard output. */
    protected final PrintWriter out(Path... targets) {
        boolean isTaken = Arrays.stream(targets).anyMatch(OutputFolder::isStandardOutput);
        return isTaken ? err() : specification.commandLine().getOut();
    }

    /** True if the command line has no option. */
    protected final boolean isPlain() {
        return specification.commandLine().getParseResult().matchedOptions().isEmpty();
    }
}
