package sunbeam.app.cli.program;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.UnmatchedArgumentException;
import sunbeam.app.cli.BenchmarkCommand;
import sunbeam.app.cli.BrdfMapCommand;
import sunbeam.app.cli.CacheCommand;
import sunbeam.app.cli.Collection;
import sunbeam.app.cli.ColorCommand;
import sunbeam.app.cli.DoctorCommand;
import sunbeam.app.cli.EvaluateCommand;
import sunbeam.app.cli.InspectCommand;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.cli.MeshCommand;
import sunbeam.app.cli.OrdersCommand;
import sunbeam.app.cli.PictureSize;
import sunbeam.app.cli.PrecomputeCommand;
import sunbeam.app.cli.Range;
import sunbeam.app.cli.ReflectanceCommand;
import sunbeam.app.cli.SampleCommand;
import sunbeam.app.cli.export.ExportCommand;
import sunbeam.app.cli.figures.FiguresCommand;
import sunbeam.app.cli.render.AnimationOptions.Sweep;
import sunbeam.app.cli.render.CompareCommand;
import sunbeam.app.cli.render.RenderCommand;
import sunbeam.app.cli.render.ViewCommand;
import sunbeam.app.failure.Failure;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.Messages.HarmlessWriter;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

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
            // Java replaces bytes that are not UTF-8 by U+FFFD: a file of this name would be another one.
            plain.forEach(argument -> UsageException.throwIf(
                    argument.contains("\ufffd"),
                    "the argument '" + argument + "' is not text in UTF-8; give the file a name that is"));
            int code = commandLine.execute(plain.toArray(String[]::new));
            if (code != ExitCode.INTERRUPTED.code() && out.checkError()) {
                throw new OutputException(OutputException.toStandardOutput("not everything was written"));
            }
            return code;
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
        Optional.ofNullable(parsed.subcommand()).ifPresent(JsonOption::requireOneStream);
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
        arguments.stream()
                .filter(argument -> !argument.startsWith("-"))
                .findFirst()
                .filter(name -> commands.containsKey(name) && !name.equals("help"))
                .ifPresentOrElse(
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
        CommandSpec command = commandLine.getCommandSpec().version("sunbeam " + Environment.version());
        UsageMessageSpec usage = command.usageMessage().abbreviateSynopsis(true);
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
            scope = ScopeType.INHERIT,
            sortOptions = false,
            synopsisHeading = "Usage: ",
            descriptionHeading = "%n",
            optionListHeading = "%nOptions:%n",
            commandListHeading = "%nCommands:%n")
    private static final class Root implements Callable<Integer>, Supplier<Environment> {
        static final String DESCRIPTION =
                "Sunbeam renders the colors that a nanostructured surface, such as a snake's skin or a compact disc,"
                        + " makes by diffraction. It reads a height map measured by an atomic force microscope, precomputes"
                        + " Fourier tables of it, and evaluates the diffraction BRDF for each pixel on the graphics card.";

        // Never read: Sunbeam replaces it by --help before parsing, and then installs the complete help.
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
    }

    /** Reports a failed command by one line on standard error and an exit code, and by a stack trace with {@code --debug}. */
    record Failures(PrintWriter err, BooleanSupplier debug) {
        private static final String BUG_REMEDY = "; run again with --debug and report what it prints";

        int report(Throwable thrown) {
            Failure failure = Failure.of(thrown instanceof ParameterException mistake ? worded(mistake) : thrown);
            ExitCode code = ShutdownHook.isProcessEnding() ? ExitCode.INTERRUPTED : failure.code();
            if (code != ExitCode.INTERRUPTED) {
                err.println(Messages.error(failure.message() + (failure.isBug() ? BUG_REMEDY : "")));
            }
            if (debug.getAsBoolean()) {
                failure.cause().printStackTrace(err);
            }
            err.flush();
            return code.code();
        }

        /** Explains why a command line cannot be parsed: the wrong argument, similar names, and the command whose help to read. */
        private static UsageException worded(ParameterException mistake) {
            String command = mistake.getCommandLine().getCommandSpec().qualifiedName();
            UsageException worded = new UsageException(describe(mistake) + "; see " + command + " --help");
            worded.initCause(mistake);
            return worded;
        }

        private static String describe(ParameterException mistake) {
            if (!(mistake instanceof UnmatchedArgumentException unmatched)) {
                return plain(mistake);
            }
            String argument = unmatched.getUnmatched().get(0);
            if (!unmatched.isUnknownOption()
                    && mistake.getCommandLine().getSubcommands().isEmpty()) {
                return "unknown argument '" + argument + "'; values follow options, without blanks or in quotes";
            }
            if (unmatched.isUnknownOption() && isOptionOfACommand(mistake, argument)) {
                return "option '" + argument + "' has no command before it; give the command first, then its options";
            }
            List<String> suggestions = closest(unmatched.getSuggestions(), argument);
            String meant = suggestions.isEmpty() ? "" : " (did you mean " + String.join(" or ", suggestions) + "?)";
            return "unknown " + (unmatched.isUnknownOption() ? "option" : "command") + " '" + argument + "'" + meant;
        }

        private static boolean isOptionOfACommand(ParameterException mistake, String argument) {
            String name = argument.split("=", 2)[0];
            return mistake.getCommandLine().getSubcommands().values().stream()
                    .anyMatch(command -> command.getCommandSpec().optionsMap().containsKey(name));
        }

        /** Returns the suggestions that differ from the argument by a typing mistake only; if there is none, all. */
        private static List<String> closest(List<String> suggestions, String argument) {
            List<String> close = suggestions.stream()
                    .filter(suggestion -> Text.areSimilar(suggestion, argument.split("=", 2)[0]))
                    .toList();
            return close.isEmpty() ? suggestions : close;
        }

        private static String plain(ParameterException mistake) {
            String text = mistake.getMessage();
            String sentence = text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
            String comma = mistake.getValue() == null ? "" : Decimals.commaRemedy(mistake.getValue());
            String worded = sentence.replaceFirst("is not an? (?:int|long)$", "is no whole number, such as 512")
                    .replaceFirst("is not an? (?:double|float)$", "is no number, such as 0.5");
            return worded.substring(0, 1).toLowerCase(Locale.ROOT) + worded.substring(1) + comma;
        }
    }
}
