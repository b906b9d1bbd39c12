package sunbeam.app.cli.options;

import static sunbeam.precompute.patch.PatchSettings.PATCH;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.Progress;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchLoader.HeightCache;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

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

    /** Returns the options of a command whose surface is an argument that must be given. */
    public static PatchOptions ofArgument() {
        return new PatchOptions(WITHOUT_PATCH, "1", "A built-in patch, a descriptor (.json) or a scan.");
    }

    /** Returns options without {@code --patch}: the command declares its own option for it. */
    public static PatchOptions withoutPatch() {
        return new PatchOptions(WITHOUT_PATCH, "", "");
    }

    @Override
    protected void declareArguments(CommandSpec own) {
        if (arity.equals(MANY)) {
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
                    .index(arity.equals(MANY) ? MANY : "0")
                    .arity(arity)
                    .paramLabel("PATCH")
                    .type(arity.equals(MANY) ? String[].class : String.class)
                    .description(words)
                    .setter(setter(text -> argument = text))
                    .build());
        }
    }

    @Override
    public Choices choices() {
        Choices choices = super.choices();
        if (argument == null) {
            return choices;
        }
        if (choices.has(PATCH)) {
            throw new UsageException("'" + argument + "' and --patch both name a patch; give one of them");
        }
        return choices.parsed(PATCH, argument, OptionOrigin.ARGUMENT);
    }

    /** Loads several patches; the same name gets a number (-2, -3, ...) the second time. */
    public List<Patch> load(List<String> names, Choices method) {
        List<Patch> patches = new ArrayList<>();
        names.forEach(name -> patches.add(ComparisonPatches.distinct(load(name, method), patches)));
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

    /** Loads the patch without the cache. */
    public Patch load(Choices method) {
        return load(choices(), method, HeightCache.NONE);
    }

    /** Loads the patch of another name with the same options. */
    public Patch load(String named, Choices method) {
        return load(choices().with(PATCH, named), method, HeightCache.NONE);
    }

    private static Patch load(Choices patch, Choices method, HeightCache cache) {
        return PatchLoader.load(new PatchRequest(patch, Preset.isThesis(method)), cache);
    }
}
