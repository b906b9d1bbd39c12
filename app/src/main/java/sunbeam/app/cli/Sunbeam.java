package sunbeam.app.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import sunbeam.app.cli.benchmark.BenchmarkCommand;
import sunbeam.app.cli.brdfmap.BrdfMapCommand;
import sunbeam.app.cli.collection.Collection;
import sunbeam.app.cli.color.ColorCommand;
import sunbeam.app.cli.compare.CompareCommand;
import sunbeam.app.cli.evaluate.EvaluateCommand;
import sunbeam.app.cli.export.ExportCommand;
import sunbeam.app.cli.figures.FiguresCommand;
import sunbeam.app.cli.inspect.InspectCommand;
import sunbeam.app.cli.options.PictureSize;
import sunbeam.app.cli.options.Range;
import sunbeam.app.cli.orders.OrdersCommand;
import sunbeam.app.cli.reflectance.ReflectanceCommand;
import sunbeam.app.cli.render.AnimationOptions.Sweep;
import sunbeam.app.cli.render.RenderCommand;
import sunbeam.app.cli.sample.SampleCommand;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.HarmlessWriter;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;

/** The program: parses a command line, runs the command, and turns failures into messages and exit codes. */
public final class Sunbeam {
    private final Environment environment;
    private final PrintWriter out;
    private final PrintWriter err;

    public Sunbeam(Environment environment, PrintWriter out, PrintWriter err) {
        this.environment = environment;
        this.out = out;
        this.err = HarmlessWriter.around(err);
    }

    /** Runs one command line and returns the exit code; never throws. */
    public int run(String... arguments) {
        Root root = new Root(environment);
        Failures failures = new Failures(err, () -> environment.debug() || root.debug);
        try {
            List<String> plain = new ArrayList<>(List.of(arguments));
            boolean completeHelp = Collections.replaceAll(plain, CommandHelp.COMPLETE, "--help");
            CommandLine commandLine = commandLine(root, completeHelp, plain);
            commandLine.setParameterExceptionHandler((failure, all) -> failures.report(failure));
            commandLine.setExecutionExceptionHandler((failure, command, result) -> failures.report(failure));
            commandLine.setExecutionStrategy(parsed -> execute(commandLine, parsed, root.quiet));
            // By U+FFFD Java replaces bytes that are not UTF-8: a file of this name would be another one.
            plain.forEach(argument -> UsageException.throwIf(
                    argument.contains("\ufffd"),
                    "the argument '" + argument + "' is not text in UTF-8; give the file a name that is"));
            return checkedExitCode(commandLine.execute(plain.toArray(String[]::new)), failures);
        } catch (Throwable failure) {
            return failures.report(failure);
        } finally {
            out.flush();
            err.flush();
        }
    }

    /** Runs the command. Control characters in its output, which may come from files, are made harmless; those of the help stay. */
    private int execute(CommandLine root, CommandLine.ParseResult parsed, boolean quiet) {
        Integer help = CommandLine.executeHelpRequest(parsed);
        if (help != null) {
            return help;
        }
        root.setOut(HarmlessWriter.around(out));
        root.setErr(quiet ? HarmlessWriter.ofErrors(err) : err);
        if (quiet) {
            environment.progress().silence();
        }
        return Optional.ofNullable(parsed.subcommand())
                .flatMap(command -> Collection.of(command, this::inner))
                .map(collection -> run(collection, parsed.subcommand()))
                .orElseGet(() -> new CommandLine.RunLast().execute(parsed));
    }

    private Collection.Outcome inner(List<String> words) {
        StringWriter stdout = new StringWriter();
        StringWriter stderr = new StringWriter();
        int code = new Sunbeam(environment, new PrintWriter(stdout), new PrintWriter(stderr))
                .run(words.toArray(String[]::new));
        return new Collection.Outcome(code, stdout.toString(), Messages.last(stderr.toString()));
    }

    /** Wraps failures, since picocli would print the stack trace of any other exception of a strategy. */
    private int run(Collection collection, CommandLine.ParseResult command) {
        CommandLine commandLine = command.commandSpec().commandLine();
        try {
            return collection.run(commandLine.getOut(), commandLine.getErr(), environment.progress());
        } catch (RuntimeException failure) {
            throw new CommandLine.ExecutionException(commandLine, failure.getMessage(), failure);
        }
    }

    private int checkedExitCode(int code, Failures failures) {
        if (code != ExitCode.INTERRUPTED.code() && out.checkError()) {
            return failures.report(new OutputException(OutputException.toStandardOutput("not everything was written")));
        }
        return code;
    }

    /** Returns all commands, in the help's order. The help constructs all, so constructors must not load OpenGL or plots. */
    private Map<String, Supplier<Object>> commands() {
        Map<String, Supplier<Object>> commands = new LinkedHashMap<>();
        commands.put("brdf-map", BrdfMapCommand::new);
        commands.put("color", ColorCommand::new);
        commands.put("reflectance", ReflectanceCommand::new);
        commands.put("inspect", InspectCommand::new);
        commands.put("evaluate", EvaluateCommand::new);
        commands.put("orders", OrdersCommand::new);
        commands.put("figures", () -> new FiguresCommand(environment.progress(), this::inner));
        commands.put("export", ExportCommand::new);
        commands.put("sample", SampleCommand::new);
        commands.put("precompute", PrecomputeCommand::new);
        commands.put("benchmark", BenchmarkCommand::new);
        commands.put("render", RenderCommand::new);
        commands.put("compare", CompareCommand::new);
        commands.put("mesh", MeshCommand::new);
        commands.put("view", ViewCommand::new);
        commands.put("cache", CacheCommand::new);
        commands.put("doctor", () -> new DoctorCommand(environment));
        commands.put("help", CommandLine.HelpCommand::new);
        return commands;
    }

    /** Returns the root command with only the command that the arguments name, which starts sooner; with all for the help. */
    private CommandLine commandLine(Root command, boolean completeHelp, List<String> arguments) {
        CommandLine root = new CommandLine(command);
        Map<String, Supplier<Object>> commands = commands();
        Optional<String> asked = arguments.stream()
                .filter(argument -> !argument.startsWith("-"))
                .findFirst()
                .filter(name -> commands.containsKey(name) && !name.equals("help"));
        asked.ifPresentOrElse(
                name -> root.addSubcommand(name, commands.get(name).get()),
                () -> commands.forEach((name, made) -> root.addSubcommand(name, made.get())));
        root.setOut(out);
        root.setErr(err);
        root.setCaseInsensitiveEnumValuesAllowed(true);
        root.registerConverter(Range.class, Range::parse);
        root.registerConverter(PictureSize.class, PictureSize::parse);
        root.registerConverter(Sweep.class, Sweep::parse);
        root.getSubcommands().values().forEach(sub -> CommandHelp.install(sub, completeHelp));
        describe(root);
        root.getCommandSpec()
                .usageMessage()
                .description(Root.DESCRIPTION)
                .footer(Environment.resource(Sunbeam.class, "footer.txt")
                        .lines()
                        .toArray(String[]::new));
        return root;
    }

    private static void describe(CommandLine commandLine) {
        UsageMessageSpec usage = commandLine.getCommandSpec().usageMessage().abbreviateSynopsis(true);
        if (usage.header().length > 0) {
            usage.synopsisHeading("%nUsage: ");
        }
        if (usage.footer().length > 0) {
            usage.footerHeading("%nExamples:%n");
        }
        usage.exitCodeListHeading("%nExit codes:%n").exitCodeList(ExitCode.table());
        commandLine.getSubcommands().values().forEach(Sunbeam::describe);
    }

    /** The command {@code sunbeam} itself, which only has subcommands; its help is the first page of the manual. */
    @CommandLine.Command(
            name = "sunbeam",
            mixinStandardHelpOptions = true,
            versionProvider = Root.ProgramVersion.class,
            scope = ScopeType.INHERIT,
            sortOptions = false,
            synopsisHeading = "Usage: ",
            descriptionHeading = "%n",
            optionListHeading = "%nOptions:%n",
            commandListHeading = "%nCommands:%n")
    private static final class Root implements Callable<Integer>, Supplier<Environment> {
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

        @CommandLine.Spec
        private CommandSpec specification;

        private final Environment environment;

        Root(Environment environment) {
            this.environment = environment;
        }

        @Override
        public Environment get() {
            return environment;
        }

        @Override
        public Integer call() {
            String commands = String.join(", ", specification.subcommands().keySet());
            throw new CommandLine.ParameterException(
                    specification.commandLine(), "No command given; there are " + commands);
        }

        static final class ProgramVersion implements CommandLine.IVersionProvider {
            @Override
            public String[] getVersion() {
                return new String[] {"sunbeam " + Environment.version()};
            }
        }
    }
}
