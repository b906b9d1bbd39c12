package sunbeam.app.cli;

import static sunbeam.precompute.patch.PatchSettings.PATCH;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Option;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.input.IndexFile;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchLoader.HeightCache;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.work.Progress;

/** Options of the surface; a picocli mixin. */
public final class PatchOptions extends SettingOptions {
    public static final String TASK = "--task";
    private static final String MANY = "0..*";
    private static final List<Setting<?>> WITHOUT_PATCH =
            PatchSettings.ALL.stream().filter(setting -> !setting.equals(PATCH)).toList();

    private final String arity;
    private final String words;
    private String argument;

    /** Makes the options of a command whose surface is named by {@code --patch} or an argument. */
    public PatchOptions() {
        this(PatchSettings.ALL, "0..1", "The surface; may be given here instead of by --patch.");
    }

    private PatchOptions(List<Setting<?>> settings, String arity, String words) {
        super(settings);
        this.arity = arity;
        this.words = words;
    }

    /** Returns the options of a command that takes any number of surfaces and folders; a {@code Collection} runs it for each. */
    public static PatchOptions ofMany() {
        return new PatchOptions(
                PatchSettings.ALL,
                MANY,
                "The surface, instead of by --patch. Of several, and of the files of a folder, each has its own output in a"
                        + " folder with a table and a sheet of thumbnails.");
    }

    /** Returns options without {@code --patch}: the command declares its own option for it. */
    public static PatchOptions withoutPatch() {
        return new PatchOptions(WITHOUT_PATCH, "", "");
    }

    @Override
    protected void declareArguments(CommandSpec own) {
        boolean many = arity.equals(MANY);
        if (many) {
            own.addOption(OptionSpec.builder(TASK)
                    .userObject(TASK)
                    .paramLabel("I/N")
                    .type(String.class)
                    .description("Of several patches, folders and angles take the I-th of N parts. The same command"
                            + " without it, with --resume, then joins all.")
                    .build());
        }
        if (!arity.isEmpty()) {
            own.addPositional(PositionalParamSpec.builder()
                    .index(many ? MANY : "0")
                    .arity(arity)
                    .paramLabel("PATCH")
                    .type(many ? String[].class : String.class)
                    .description(words)
                    .setter(setter(text -> argument = text))
                    .build());
        }
    }

    /** Returns the surface's name that is given without an option. */
    public Optional<String> argument() {
        return Optional.ofNullable(argument);
    }

    /** Returns the choices of the options alone. */
    public Choices options() {
        return super.choices();
    }

    @Override
    public Choices choices() {
        Choices choices = super.choices();
        if (argument == null) {
            return choices;
        }
        UsageException.throwIf(
                choices.has(PATCH), "'" + argument + "' and --patch both name a patch; give one of them");
        return choices.parsed(PATCH, argument, OptionOrigin.ARGUMENT);
    }

    /** Loads several patches; the same name gets a number (-2, -3, ...) the second time. */
    public List<Patch> load(List<String> names, Choices method) {
        List<Patch> patches = new ArrayList<>();
        names.forEach(name -> patches.add(Compared.distinct(load(name, method), patches)));
        return patches;
    }

    /** Loads the patch, as the method's preset reads it; the heights of a built-in patch may come from the cache. */
    public Patch load(Choices method, Environment environment, PrintWriter err) {
        BlobCache cache = BlobCache.of(environment, warning -> err.println(Messages.warning(warning)));
        try (Progress progress = environment.progress().start("Reading the heights", 1)) {
            Patch patch = load(choices(), method, cache::heights);
            progress.step(1);
            return patch;
        }
    }

    public Patch load(Choices method) {
        return load(choices(), method, HeightCache.NONE);
    }

    public Patch load(String named, Choices method) {
        return load(choices().with(PATCH, named), method, HeightCache.NONE);
    }

    private static Patch load(Choices patch, Choices method, HeightCache cache) {
        return PatchLoader.load(new PatchRequest(patch, Preset.isThesis(method)), cache);
    }

    /** Value of the option {@code --task I/N}: the I-th, from 1, of N consecutive parts of a list. */
    public record TaskPart(int number, int parts) {

        public static TaskPart parse(String text) {
            String[] numbers = text.matches("\\d{1,6}/\\d{1,6}") ? text.split("/", -1) : new String[] {"0", "0"};
            TaskPart part = new TaskPart(Integer.parseInt(numbers[0]), Integer.parseInt(numbers[1]));
            UsageException.throwIf(
                    part.number < 1 || part.number > part.parts,
                    "--task " + text + " names no part; give I/N, 1/8 to 8/8 for the eight parts of eight");
            return part;
        }

        public long first(long count) {
            return count * (number - 1) / parts;
        }

        public long end(long count) {
            return count * number / parts;
        }
    }

    /** Option {@code --with}, which adds surfaces to compare with the first; a picocli mixin. */
    public static final class Compared {
        private static final int MOST = 24;

        @Option(
                names = "--with",
                paramLabel = "PATCH",
                description =
                        "Another surface to show beside it at the same exposure, with the same options; may be repeated.")
        private List<String> others = new ArrayList<>();

        public boolean areSeveral() {
            return !others.isEmpty();
        }

        public List<Patch> load(PatchOptions first, Choices method, ProgressDisplay display) {
            UsageException.throwIf(
                    others.size() > MOST,
                    "--with is given " + others.size() + " times; give it " + MOST + " times at most");
            try (Progress progress = display.start("Reading the heights", 1 + others.size())) {
                List<Patch> patches = new ArrayList<>(List.of(first.load(method)));
                progress.step(1);
                for (String name : others) {
                    patches.add(distinct(first.load(name, method), patches));
                    progress.step(1);
                }
                return patches;
            }
        }

        /** Adds a number to the patch's name if an earlier patch has that name. */
        static Patch distinct(Patch patch, List<Patch> earlier) {
            Set<String> earlierNames = earlier.stream().map(Patch::name).collect(Collectors.toSet());
            String name = patch.name();
            for (int i = 2; earlierNames.contains(name); i++) {
                name = patch.name() + "-" + i;
            }
            return name.equals(patch.name())
                    ? patch
                    : patch.named(name, "renamed, since another surface has the name " + patch.name());
        }
    }

    /** Option {@code --index}, the material of the surface; a picocli mixin. */
    public static final class IndexOption {
        @Option(
                names = "--index",
                paramLabel = "N",
                defaultValue = "1.5",
                description =
                        "Refractive index of the surface: a number (1.5, keratin, is the default), n+ki for metals and"
                                + " coats of metal (0.97+6.5i), or a CSV file in the form of refractiveindex.info, by wavelength.")
        private String index;

        /** Describes the result of {@link #parse} for metadata; a tabulated index with its file's name. */
        public String describe(RefractiveIndex parsed) {
            return IndexFile.isName(index)
                    ? Path.of(index).getFileName() + ", " + parsed.describe()
                    : parsed.describe();
        }

        /** Parses the option, or reads the file that it names; throws UsageException or InputException if they cannot be used. */
        public RefractiveIndex parse() {
            return UsageException.parsed(
                    "--index " + index + ": ",
                    () -> IndexFile.isName(index) ? IndexFile.read(Path.of(index)) : RefractiveIndex.parse(index));
        }
    }

    /** Lists the surfaces that the arguments of a command name. A folder stands for its files, in the order of their names. */
    static final class Surfaces {
        /** Largest size of a descriptor, bytes; the reader of patches refuses larger ones. */
        private static final long LARGEST_DESCRIPTOR = 1 << 20;

        private static final String HEIGHTS = "heights";

        private Surfaces() {}

        static boolean isFolder(String name) {
            return !BuiltInPatches.names().contains(name) && new File(name).isDirectory();
        }

        /**
         * A missing file among several names counts if its name has a folder or an ending: its run reports it.
         *
         * @throws InputException if another name is neither a built-in patch nor an existing file, or if a folder cannot be read or has no file
         */
        static List<String> of(List<String> names) {
            names.forEach(name -> InputException.refuseIf(
                    !BuiltInPatches.names().contains(name)
                            && !new File(name).exists()
                            && (names.size() == 1 || !name.matches("(?s).*[./\\\\].*")),
                    "'" + name
                            + "' is neither a built-in patch nor an existing file; a name with blanks needs quotes"));
            return names.stream()
                    .flatMap(name -> isFolder(name) ? files(Path.of(name)).stream() : Stream.of(name))
                    .toList();
        }

        /**
         * Returns a folder's own files without hidden ones, those that a usable descriptor of the folder names, and other JSON and Markdown.
         * A link that leads nowhere or out of the folder, or a pipe, counts: its row says so.
         */
        private static List<String> files(Path folder) {
            try (Stream<Path> listed = Files.list(folder)) {
                List<Path> files = listed.filter(file -> !Files.isDirectory(file)
                                && !file.getFileName().toString().matches("(?i)\\..*|.*\\.md")
                                && (OwnFolder.isWayOut(file, folder)
                                        || json(file)
                                                .map(tree -> tree.has(HEIGHTS))
                                                .orElse(true)))
                        .sorted()
                        .toList();
                Set<Path> described = new HashSet<>();
                files.stream()
                        .filter(file -> !OwnFolder.isWayOut(file, folder))
                        .forEach(file ->
                                PatchLoader.described(file).map(Path::normalize).ifPresent(described::add));
                InputException.refuseIf(
                        files.isEmpty(),
                        "the folder " + folder
                                + " has no scan; folders below it and hidden files do not count, name the folder of the scans");
                return files.stream()
                        .filter(file -> !described.contains(file.normalize())
                                || OwnFolder.isWayOut(file, folder)
                                || json(file).isPresent())
                        .map(Path::toString)
                        .toList();
            } catch (IOException failure) {
                throw InputException.of(folder, failure);
            } catch (UncheckedIOException failure) {
                throw InputException.of(folder, failure.getCause());
            }
        }

        /**
         * Empty if the file is no JSON, or cannot be read: the command reads it later and reports what is wrong. No more is read than the
         * file's size, which is 0 for files of the kernel.
         */
        private static Optional<JsonNode> json(Path file) {
            if (!file.toString().toLowerCase(Locale.ROOT).endsWith(".json") || !Files.isRegularFile(file)) {
                return Optional.empty();
            }
            try (InputStream stream = Files.newInputStream(file)) {
                long size = Files.size(file);
                return size > LARGEST_DESCRIPTOR
                        ? Optional.empty()
                        : Optional.of(new ObjectMapper().readTree(stream.readNBytes((int) size)));
            } catch (IOException broken) {
                return Optional.empty();
            }
        }
    }
}
