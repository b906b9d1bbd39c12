package sunbeam.app.commands.figures;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputExistsException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.Version;
import sunbeam.app.terminal.progress.Progress;

/** {@code sunbeam figures}: runs the commands of the manifest, one a picture, and writes a page of them. */
@Command(
        name = "figures",
        header = "Draw the thesis's result figures as one folder with a page.",
        description = "Draw the result figures of the thesis as one folder: BRDF maps per patch (5.3), method (5.4),"
                + " wavelength step (5.5, 5.6), full against pq (5.7 to 5.9), per coherence window (5.10), number of"
                + " terms (5.11, 5.12) and angle of incidence (5.13); the evaluation by the grating equation (4.9 to"
                + " 4.11). Pictures that the same command has drawn are kept, so that a run which was stopped goes on where"
                + " it ended. Look at index.html, which names the command of each picture.")
public final class FiguresCommand implements Callable<Integer> {
    private static final int LARGEST = 2048;
    private static final long LARGEST_RECORD = 1 << 20;
    private static final String PAGE = "index.html";
    private static final String RECORD = "figures.json";
    private static final Map<String, String> BUILT_IN =
            Map.of("blaze", "blaze", "elaphe", "elaphe-like", "xenopeltis", "xenopeltis-like");

    private final CommandRunner runner;

    @Option(
            names = "--output",
            paramLabel = "FOLDER",
            defaultValue = "figures",
            description = "The folder, made where it is missing. Default: ${DEFAULT-VALUE}.")
    private Path output;

    @Option(
            names = "--only",
            paramLabel = "NUMBER",
            split = ",",
            description = "Only these figures, for example 5.10 or 5.3,5.4. The page shows all that the folder has.")
    private List<String> only = new ArrayList<>();

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "256",
            description = "Width and height of each map, 16 to 2048. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Option(
            names = "--patches",
            paramLabel = "FOLDER",
            description = "Folder with the measured patches blaze.json, elaphe.json and xenopeltis.json. Default: the"
                    + " built-in patches blaze, elaphe-like and xenopeltis-like.")
    private Path patchFolder;

    @Mixin
    private ForceOption force;

    @Spec
    private CommandSpec specification;

    /** @param runner of the manifest's commands */
    public FiguresCommand(CommandRunner runner) {
        this.runner = runner;
    }

    /** A picture of one patch. */
    private record Task(Figure figure, String patch, Figure.Picture picture, List<String> command) {
        String file() {
            return figure.file(patch, picture);
        }
    }

    @Override
    public Integer call() {
        if (size < 16 || size > LARGEST) {
            throw new UsageException("--size " + size + " is out of range; give 16 to " + LARGEST);
        }
        List<Task> tasks = tasks(Figure.select(only));
        OutputFolder.create(output);
        checkPage();
        Map<String, Drawn> drawn = record();
        List<Task> missing =
                tasks.stream().filter(task -> !isDrawn(task, drawn)).toList();
        missing.forEach(this::requireFree);
        int code = draw(missing, drawn);
        write(PAGE, FiguresPage.of(Figure.all(), drawn));
        specification.commandLine().getOut().println(output.resolve(PAGE));
        return code;
    }

    private List<Task> tasks(List<Figure> figures) {
        List<Task> tasks = new ArrayList<>();
        for (Figure figure : figures) {
            for (String patch : figure.patches()) {
                for (Figure.Picture picture : figure.pictures()) {
                    tasks.add(new Task(
                            figure, patch, picture, figure.command(patch, picture, source(patch), size, output)));
                }
            }
        }
        return tasks;
    }

    private String source(String patch) {
        if (patchFolder == null) {
            return BUILT_IN.get(patch);
        }
        Path descriptor = patchFolder.resolve(patch + ".json");
        if (!Files.isRegularFile(descriptor)) {
            throw new UsageException("--patches " + patchFolder + ": there is no " + patch
                    + ".json; give a folder with blaze.json, elaphe.json and xenopeltis.json");
        }
        return descriptor.toString();
    }

    private boolean isDrawn(Task task, Map<String, Drawn> drawn) {
        Drawn known = drawn.get(task.file());
        return known != null
                && Version.number().equals(known.version())
                && String.join(" ", task.command()).equals(known.command())
                && Files.isRegularFile(output.resolve(task.file()));
    }

    /** Before anything is drawn. */
    private void requireFree(Task task) {
        Path file = output.resolve(task.file());
        if (force.overwrite() == Overwrite.REFUSE && Files.exists(file)) {
            throw new OutputExistsException("cannot write " + file
                    + ": it exists, with other parameters; add --force to replace it, or choose another --output");
        }
    }

    /** Returns the exit code of the first command that failed. */
    private int draw(List<Task> missing, Map<String, Drawn> drawn) {
        int code = ExitCode.OK.code();
        try (Progress progress = Progress.start("Figures", missing.size())) {
            for (Task task : missing) {
                StringWriter out = new StringWriter();
                StringWriter err = new StringWriter();
                List<String> words = new ArrayList<>(task.command());
                words.add("--force");
                int result = runner.run(new PrintWriter(out), new PrintWriter(err), words.toArray(String[]::new));
                if (result == ExitCode.INTERRUPTED.code()) {
                    return result;
                }
                // What can only be a mistake is drawn all the same, and says so.
                if (result != ExitCode.OK.code() && result != ExitCode.TOLERANCE_MISSED.code()) {
                    code = code == ExitCode.OK.code() ? result : code;
                    complain(task, err.toString());
                } else {
                    drawn.put(
                            task.file(),
                            new Drawn(
                                    Version.number(), String.join(" ", task.command()), caption(task, out.toString())));
                    writeRecord(drawn);
                }
                progress.step(1);
            }
        }
        return code;
    }

    private void complain(Task task, String err) {
        String last = err.lines().reduce((first, second) -> second).orElse("it said nothing");
        PrintWriter complaints = specification.commandLine().getErr();
        complaints.println(Messages.error("figure " + task.file() + ": " + last.replaceFirst("^sunbeam: ", "")));
        complaints.flush();
    }

    /** What a command said before the names of its files, and how its picture differs from the first. */
    private String caption(Task task, String out) {
        if (task.figure().isCompared(task.picture())) {
            Path base = output.resolve(
                    task.figure().file(task.patch(), task.figure().pictures().get(0)));
            return PictureDifference.of(
                            PictureDifference.read(output.resolve(task.file())), PictureDifference.read(base))
                    .text();
        }
        String first = out.lines().findFirst().orElse("");
        return task.command().get(0).equals("evaluate") ? first : "";
    }

    /** A page that another program wrote stays. */
    private void checkPage() {
        Path page = output.resolve(PAGE);
        AtomicFile.checkWritable(page, Overwrite.REPLACE);
        try {
            if (force.overwrite() == Overwrite.REFUSE
                    && Files.exists(page)
                    && !Files.readString(page).contains(FiguresPage.GENERATOR)) {
                throw new OutputExistsException(
                        "cannot write " + page
                                + ": it exists and is no page of figures; add --force to replace it, or choose another --output");
            }
        } catch (IOException failure) {
            throw OutputException.of(page, failure);
        }
    }

    /** What the folder has; nothing where its record is damaged. */
    private Map<String, Drawn> record() {
        Path file = output.resolve(RECORD);
        try {
            if (!Files.exists(file) || Files.size(file) > LARGEST_RECORD) {
                return new TreeMap<>();
            }
            Map<String, Drawn> drawn = new ObjectMapper()
                    .readValue(Files.readString(file), new TypeReference<TreeMap<String, Drawn>>() {});
            drawn.keySet().retainAll(there());
            drawn.values().removeIf(Objects::isNull);
            return drawn;
        } catch (JsonProcessingException damaged) {
            return new TreeMap<>();
        } catch (IOException failure) {
            throw OutputException.of(file, failure);
        }
    }

    /** The manifest's pictures that the folder has. */
    private Set<String> there() {
        return tasks(Figure.all()).stream()
                .map(Task::file)
                .filter(name -> Files.isRegularFile(output.resolve(name)))
                .collect(Collectors.toSet());
    }

    private void writeRecord(Map<String, Drawn> drawn) {
        try {
            ObjectMapper json = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
            write(RECORD, json.writeValueAsString(drawn));
        } catch (JsonProcessingException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private void write(String name, String content) {
        AtomicFile.write(
                output.resolve(name),
                Overwrite.REPLACE,
                stream -> stream.write(content.getBytes(StandardCharsets.UTF_8)));
    }
}
