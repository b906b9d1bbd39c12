package sunbeam.app.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;
import sunbeam.app.cli.options.ReportingCommand;
import sunbeam.app.terminal.Environment;

/** The command {@code sunbeam} itself, which only has subcommands; its help is the first page of the manual. */
@Command(
        name = "sunbeam",
        mixinStandardHelpOptions = true,
        versionProvider = RootCommand.ProgramVersion.class,
        scope = ScopeType.INHERIT,
        sortOptions = false,
        synopsisHeading = "Usage: ",
        descriptionHeading = "%n",
        optionListHeading = "%nOptions:%n",
        commandListHeading = "%nCommands:%n")
final class RootCommand implements Callable<Integer>, ReportingCommand.Root {
    static final String[] DESCRIPTION = {
        "Sunbeam renders the colors that a nanostructured surface, such as a snake's skin or a compact disc,"
                + " makes by diffraction. It reads a height map measured by an atomic force microscope, precomputes"
                + " Fourier tables of it, and evaluates the diffraction BRDF for each pixel on the graphics card."
    };

    // Never read: Sunbeam replaces this option by --help before the command line is parsed, and then installs the
    // complete help.
    @Option(
            names = CommandHelp.COMPLETE,
            scope = ScopeType.INHERIT,
            description = "Show all options of a command, whole descriptions and exit codes.")
    @SuppressWarnings("UnusedVariable")
    private boolean completeHelp;

    @Option(
            names = "--debug",
            scope = ScopeType.INHERIT,
            description = "Print the stack trace of a failure below its message.")
    private boolean debug;

    @Option(
            names = "--quiet",
            scope = ScopeType.INHERIT,
            description = "Print only failures on standard error: no plan, no warning, no progress.")
    private boolean quiet;

    @Spec
    private CommandSpec specification;

    private final Environment environment;

    RootCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Environment environment() {
        return environment;
    }

    static String[] footer() {
        return Environment.resource(RootCommand.class, "footer.txt").lines().toArray(String[]::new);
    }

    boolean debug() {
        return debug;
    }

    boolean quiet() {
        return quiet;
    }

    @Override
    public Integer call() {
        String commands = String.join(", ", specification.subcommands().keySet());
        throw new ParameterException(specification.commandLine(), "No command given; there are " + commands);
    }

    static final class ProgramVersion implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"sunbeam " + Environment.version()};
        }
    }
}
