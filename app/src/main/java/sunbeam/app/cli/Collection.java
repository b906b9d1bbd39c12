package sunbeam.app.cli;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.File;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import sunbeam.app.cli.PatchOptions.Surfaces;
import sunbeam.app.cli.PatchOptions.TaskPart;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.work.Progress;

/**
 * A command over several surfaces, or angles of the light. It runs once for each of them, two at a time, as if it were called for that one
 * with {@code --json} and its file as {@code --output}. Their reports become a {@link CollectionFolder}. A surface that cannot be used
 * does not stop the others.
 */
public record Collection(ParseResult parsed, Function<List<String>, Outcome> runner) {
    private static final String THETA_I = "--theta-i";
    private static final String OUTPUT = "--output";

    /** Options that the collection gives to each run itself. */
    private static final Set<String> OWN =
            Set.of(PatchOptions.TASK, THETA_I, OUTPUT, "--patch", "--json", "--resume", "--force");

    private static final List<String> OF_ONE = List.of("--with", "--linear");

    private static final int MOST = 100_000;
    // Much of a surface's time is on one processor.
    private static final int AT_ONCE = 2;
    /** Bytes of a file whose heights may take much of the memory. */
    private static final long LARGE = 4 << 20;

    private static final int NAMES_OF_FOLDER = 3;
    /** Bytes; a file's name may have 255, with number, angle and ending. */
    private static final int LONGEST_STEM = 200;

    /** Result of a command line: exit code, standard output, and the last line of standard error, without the program's name. */
    public record Outcome(int code, String out, String message) {
        /** True if the command has written its files, whether or not it has kept its tolerance. */
        public boolean isWritten() {
            return code == ExitCode.OK.code() || code == ExitCode.TOLERANCE_MISSED.code();
        }
    }

    /** One run: surface, options in the form {@code --name=value}, and name of its files, which no other run has. */
    record Item(String patch, List<String> options, String stem) {}

    /** Returns the collection that a command line means; empty if it means one surface under one light. */
    public static Optional<Collection> of(ParseResult command, Function<List<String>, Outcome> runner) {
        boolean possible = command.commandSpec().positionalParameters().stream()
                .anyMatch(argument -> argument.arity().max() > 1);
        Collection collection = new Collection(command, runner);
        List<String> arguments = collection.arguments();
        boolean several = arguments.size() > 1
                || arguments.stream().anyMatch(Surfaces::isFolder)
                || command.hasMatchedOption(PatchOptions.TASK)
                || collection.isSweep();
        return Optional.of(collection).filter(one -> possible && several);
    }

    /** True if the command takes one angle of the light, and several are given; orders takes a range itself. */
    private boolean isSweep() {
        return value(THETA_I).orElse("").contains(":")
                && parsed.matchedOption(THETA_I).type() != Range.class;
    }

    private List<String> arguments() {
        return parsed.matchedPositionals().stream()
                .distinct()
                .flatMap(argument -> argument.originalStringValues().stream())
                .toList();
    }

    /** Returns the surfaces and folders that the command line names; the command's default if there are none. */
    private List<String> names() {
        return arguments().isEmpty()
                ? List.of(value("--patch").orElse(Choices.none().get(PatchSettings.PATCH)))
                : arguments();
    }

    private Optional<String> value(String option) {
        return Optional.ofNullable(parsed.matchedOption(option))
                .map(spec -> spec.originalStringValues().get(0));
    }

    /** Runs the command for all surfaces. Returns the exit code of the first one that failed, else 3 if a surface has it. */
    public int run(PrintWriter out, PrintWriter err, ProgressDisplay display) {
        check();
        List<Item> all = items();
        TaskPart task = TaskPart.parse(value(PatchOptions.TASK).orElse("1/1"));
        List<Item> items = all.subList((int) task.first(all.size()), (int) task.end(all.size()));
        Overwrite overwrite = replaces() ? Overwrite.REPLACE : Overwrite.REFUSE;
        CollectionFolder folder = CollectionFolder.open(folder(), task, overwrite, parsed.hasMatchedOption("--resume"));
        folder.requireFree(items, overwrite);
        List<ObjectNode> rows = new ArrayList<>();
        String kept = "interrupted; what is finished is kept, add --resume to go on";
        ShutdownHook hook = new ShutdownHook(() -> err.println(Messages.error(kept)));
        ReadWriteLock large = new ReentrantReadWriteLock();
        ExecutorService pool = Executors.newFixedThreadPool(AT_ONCE);
        try (Progress progress = display.start("Surfaces", items.size())) {
            List<CompletableFuture<ObjectNode>> made = items.stream()
                    .map(item -> CompletableFuture.supplyAsync(() -> row(item, folder, large), pool))
                    .toList();
            for (CompletableFuture<ObjectNode> next : made) {
                ObjectNode row = next.join();
                tell(row, err);
                if (failed(row) && wouldStopAll(code(row), folder)) {
                    return code(row);
                }
                folder.append(row);
                rows.add(row);
                progress.step(1);
            }
        } finally {
            pool.shutdownNow();
            hook.close();
        }
        print(out, rows, folder.write(command(), rows, display));
        return Stream.concat(rows.stream().filter(Collection::failed), rows.stream())
                .mapToInt(Collection::code)
                .filter(code -> code != ExitCode.OK.code())
                .findFirst()
                .orElse(ExitCode.OK.code());
    }

    /** Returns the row of a surface, while at most one other is made, and none beside a large file. */
    private ObjectNode row(Item item, CollectionFolder folder, ReadWriteLock large) {
        Optional<Outcome> refused = refused(item);
        Optional<String> hash = refused.isPresent() ? Optional.empty() : hash(item);
        return hash.flatMap(known -> folder.find(item, known)).orElseGet(() -> {
            Lock lock = new File(item.patch()).length() > LARGE ? large.writeLock() : large.readLock();
            lock.lock();
            try {
                return folder.row(item, hash.orElse(""), refused.orElseGet(() -> run(item, folder)));
            } finally {
                lock.unlock();
            }
        });
    }

    private static void tell(ObjectNode row, PrintWriter err) {
        if (failed(row) && code(row) != ExitCode.INTERRUPTED.code()) {
            String message = row.get("message").textValue();
            String file = row.get("file").textValue();
            err.println(Messages.error(message.contains(file) ? message : file + ": " + message));
        }
    }

    /** Returns the failure of a folder's link to a file elsewhere, which is not read unless the command line names the link itself. */
    private Optional<Outcome> refused(Item item) {
        Path file = Path.of(item.patch());
        if (!OwnFolder.isWayOut(file, file.toAbsolutePath().getParent()) || names().contains(item.patch())) {
            return Optional.empty();
        }
        String remedy = " is a link that leads out of the folder; name the link itself, or copy the file there";
        return Optional.of(new Outcome(ExitCode.UNUSABLE_INPUT.code(), "", item.patch() + remedy));
    }

    /** True if all further surfaces would fail, too: the process is ending, the folder takes no files, or there is no graphics. */
    private static boolean wouldStopAll(int code, CollectionFolder folder) {
        try {
            if (code == ExitCode.CANNOT_WRITE.code()) {
                AtomicFile.checkWritable(folder.picture("probe"), Overwrite.REPLACE);
            } else if (code == ExitCode.NO_GRAPHICS.code()) {
                RenderContext.offscreen().close();
            }
            return code == ExitCode.INTERRUPTED.code();
        } catch (OutputException | GraphicsException ofAll) {
            return true;
        }
    }

    private static int code(ObjectNode row) {
        return row.get("exit_code").intValue();
    }

    private void check() {
        OF_ONE.forEach(option -> UsageException.throwIf(
                parsed.hasMatchedOption(option),
                option + " is for one patch; leave it out, or give one patch and one --theta-i"));
        UsageException.throwIf(
                value(OUTPUT).orElse("").endsWith(".png"),
                OUTPUT + " of several patches or angles is a folder; give a name without .png, or one patch");
        UsageException.throwIf(
                parsed.hasMatchedOption("--patch")
                        && !parsed.matchedPositionals().isEmpty(),
                "'" + names().get(0) + "' and --patch both name a patch; give one of them, or all without --patch");
    }

    private List<Item> items() {
        List<String> names = Surfaces.of(names());
        List<String> angles = angles();
        UsageException.throwIf(
                (long) names.size() * angles.size() > MOST,
                names.size() + " surfaces under " + angles.size() + " angles are more than " + MOST + "; give fewer");
        List<Item> items = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        for (String name : names) {
            String stem = FileNames.cut(FileNames.stem(Path.of(name)), LONGEST_STEM);
            String free = stem;
            for (int number = 2; !taken.add(free); number++) {
                free = stem + "-" + number;
            }
            for (String angle : angles) {
                List<String> options = new ArrayList<>(given());
                options.add("--patch=" + name);
                if (!angle.isEmpty()) {
                    options.add(THETA_I + "=" + angle);
                }
                items.add(new Item(name, options, angles.size() > 1 ? free + "-theta-" + angle : free));
            }
        }
        return items;
    }

    private List<String> angles() {
        String text = value(THETA_I).orElse("");
        if (!isSweep()) {
            return List.of(text);
        }
        try {
            return Arrays.stream(Range.parse(text).values())
                    .mapToObj(Decimals::format)
                    .toList();
        } catch (TypeConversionException wrong) {
            throw new UsageException(THETA_I + ": " + wrong.getMessage());
        }
    }

    private List<String> given() {
        return parsed.matchedOptions().stream()
                .filter(option -> !OWN.contains(option.longestName()))
                .flatMap(Collection::words)
                .toList();
    }

    private static Stream<String> words(OptionSpec option) {
        String name = option.longestName();
        return option.originalStringValues().stream().map(value -> {
            boolean isFlag = option.arity().max() == 0;
            boolean isOff = isFlag && value.equals("false");
            return isOff ? name.replaceFirst("^--", "--no-") : isFlag ? name : name + "=" + value;
        });
    }

    /**
     * Returns a hash of all that determines a run's report: its options and, for a descriptor, the file of its heights. Empty if a file
     * cannot be read, which the run reports.
     */
    private Optional<String> hash(Item item) {
        List<String> words = new ArrayList<>(item.options());
        words.add(command());
        PatchLoader.described(Path.of(item.patch())).ifPresent(file -> words.add("--heights=" + file));
        try {
            return Optional.of(ResumeOption.hash(words));
        } catch (InputException unreadable) {
            return Optional.empty();
        }
    }

    private String command() {
        return parsed.commandSpec().name();
    }

    private boolean replaces() {
        return parsed.hasMatchedOption("--resume") || parsed.hasMatchedOption("--force");
    }

    private Path folder() {
        Optional<Path> named = value(OUTPUT).map(Path::of);
        String names = names().stream()
                .map(name -> FileNames.stem(Path.of(name).toAbsolutePath().normalize()))
                .limit(NAMES_OF_FOLDER)
                .collect(Collectors.joining("-"));
        boolean mayExist = named.isPresent() || replaces() || parsed.hasMatchedOption(PatchOptions.TASK);
        return OutputFolder.claim(
                named.orElse(Path.of(FileNames.cut(command() + "-" + names, LONGEST_STEM))), mayExist);
    }

    private Outcome run(Item item, CollectionFolder folder) {
        List<String> words = new ArrayList<>(List.of(command(), "--json"));
        words.addAll(item.options());
        words.add(OUTPUT + "=" + folder.picture(item.stem()));
        if (replaces()) {
            words.add("--force");
        }
        return runner.apply(words);
    }

    private static boolean failed(JsonNode row) {
        return !row.get("message").textValue().isEmpty();
    }

    private void print(PrintWriter out, List<ObjectNode> rows, List<Path> written) {
        Map<String, Long> verdicts = rows.stream()
                .collect(Collectors.groupingBy(
                        row -> row.at("/report/verdict_code").asText("failed"),
                        LinkedHashMap::new,
                        Collectors.counting()));
        if (parsed.hasMatchedOption("--json")) {
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("surfaces", rows.size());
            report.put("verdict_codes", verdicts);
            report.put("files", written.stream().map(Path::toString).toList());
            out.println(JsonOption.text(JsonOption.withCommand(command(), report)));
            return;
        }
        String counts = verdicts.entrySet().stream()
                .map(entry -> entry.getValue() + " " + entry.getKey())
                .collect(Collectors.joining(", "));
        out.println(rows.size() + (rows.size() == 1 ? " surface: " : " surfaces: ") + counts);
        written.forEach(file -> out.println(OutputFolder.name(file)));
    }
}
