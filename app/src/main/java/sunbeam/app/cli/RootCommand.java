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

    static final String[] FOOTER = {
        "",
        "Files:",
        "  Outputs are written under a temporary name in their folder and renamed when",
        "  complete: none is ever half there, also after Ctrl-C. A file that you name",
        "  (--output) is not overwritten without --force; a name that Sunbeam chooses",
        "  gets a number (-2, -3, ...) where it is taken.",
        "  The name - is standard output; messages then go to standard error.",
        "  Tables are kept in $XDG_CACHE_HOME/sunbeam, else in ~/.cache/sunbeam.",
        "  Removing that folder costs time only.",
        "",
        "In a clone, also (each with --help):",
        "  ./sunbeam test        builds everything and runs all tests",
        "  ./sunbeam archive     packs the program for other systems",
        "",
        "Environment:",
        "  DISPLAY               the X display to render through",
        "  XDG_CACHE_HOME        where the cache folder lies",
        "  SUNBEAM_DEBUG         1 prints stack traces, as --debug does",
        "  SUNBEAM_JAVA_OPTIONS  more options for Java, for example -Xmx8g for a larger heap",
        "",
        "Examples:",
        "  sunbeam doctor                        does rendering work here?",
        "  sunbeam brdf-map                      the map of the default patch",
        "  sunbeam brdf-map --patch scan.png --width 65um --max-height 375nm --theta-i 30",
        "  sunbeam inspect --patch scan.json     what a scan is like",
        "  sunbeam render elaphe                 a scene as a picture",
        "  sunbeam view                          the snake in a window",
        "  sunbeam brdf-map --help               what most users need; --help-all: all",
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

    boolean debug() {
        return debug;
    }

    /** True if only failures are printed; valid once the command line has been parsed. */
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
