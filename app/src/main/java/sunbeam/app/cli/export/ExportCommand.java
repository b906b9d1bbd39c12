package sunbeam.app.cli.export;

import static sunbeam.app.scene.SceneSettings.ENERGY;
import static sunbeam.precompute.patch.PatchSettings.PATCH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.Certificate;
import sunbeam.app.cli.FileCommand;
import sunbeam.app.cli.MethodOptions;
import sunbeam.app.cli.PatchOptions;
import sunbeam.app.cli.SettingOptions;
import sunbeam.app.cli.render.SceneOverrides;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneLoader.LoadingScene;
import sunbeam.app.render.WebScene;
import sunbeam.app.scene.Energy;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.color.WavelengthBand.SpectralBands;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;

/** Command {@code sunbeam export}: writes a surface's table of colors as a file for other programs. */
@Command(
        name = "export",
        header = "Write a surface's table of colors for other programs.",
        description = "Write the colors C(u, v, w) that a surface diffracts (mean over all positions of the coherence"
                + " window), for every light and view, as a table for other programs. It is the finest table within"
                + " --size; if need be its light has a shorter coherence length, so that orders are wider. Each output"
                + " states its content and its error against the exact reference. See docs/export.md.",
        footer = {
            "  sunbeam export close-up --format html --output snake.html",
            "  sunbeam export blaze --format html --output page.html",
            "  sunbeam export scan.gwy --format npz --output colors.npz --size 50MB"
        })
public final class ExportCommand extends FileCommand {
    private static final double SMALLEST_ANGLE = 5;
    private static final int MOST_SAMPLES = 10_000;
    /** Bands of 10 nm from 380 to 780 nm. */
    private static final int BANDS = 41;
    /** A page of this size opens in two seconds. */
    private static final String SCENE_SIZE = "6MB";

    @Mixin
    private final PatchOptions patchOptions = new PatchOptions();

    @Mixin
    private final SettingOptions settings = MethodOptions.ofTables(Map.of(
            TOLERANCE,
            "0.02, for bsdf, html, glsl and osl 0.05; the table's steps are proportional to its square root"));

    @Mixin
    private final SettingOptions energy = new SettingOptions(List.of(ENERGY));

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            required = true,
            description =
                    "One of npz, bsdf, html, glsl, osl. npz: arrays for NumPy. bsdf: the material measured of Mitsuba 3 and pbrt-v4. html: a page of a scene, or with a map and a sphere of a surface."
                            + " glsl: a folder with a function in GLSL, HLSL and WGSL, its table as KTX2 and EXR, and a page that uses it."
                            + " osl: a folder with a shader in Open Shading Language and its table as EXR.")
    private Format format;

    @Option(
            names = "--scene",
            paramLabel = "SCENE",
            description =
                    "For html: the scene that the page shows, in place of PATCH, where a patch has its name, too.")
    private String sceneName;

    @Option(
            names = "--channels",
            paramLabel = "COLORS",
            description = "For npz: xyz (default); rec709, linear and negative where a color is outside of its gamut;"
                    + " or spectral, the power in --bands of wavelengths, whatever the light.")
    private NpzTable.Channels channels;

    @Option(
            names = "--bands",
            paramLabel = "N",
            description =
                    "Bands of --channels spectral and of bsdf, from the first to the last of --wavelengths. Default: "
                            + BANDS + ", every 10 nm; for bsdf as many as the width of orders needs.")
    private Integer bands;

    @Option(
            names = "--theta-max",
            paramLabel = "ANGLE",
            defaultValue = "90",
            description =
                    "Largest angle of light and view to the normal in degrees, 5 to 90. Default: ${DEFAULT-VALUE}.")
    private double largestAngle;

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            description =
                    "Largest size of the output. Default: 100MB; 1MB for html, of a scene 6MB; 50MB for glsl and osl.")
    private String size;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "Pairs of directions at which the exact reference is evaluated, half of them on orders, 0 to "
                    + MOST_SAMPLES
                    + ": one takes half a minute on a scan. Default: up to 4, as many as a tenth of the table's"
                    + " time allows; so are the pairs for sums over wavelengths, else 1000.")
    private Integer samples;

    @Option(
            names = "--output",
            paramLabel = "OUT",
            required = true,
            description = "The file; for glsl and osl, the folder.")
    private Path output;

    @Override
    public Integer call() {
        Choices choices = settings.choices();
        return choices.located(() -> export(choices));
    }

    private int export(Choices asked) {
        if (!(largestAngle >= SMALLEST_ANGLE && largestAngle <= 90)) {
            throw new UsageException("--theta-max " + largestAngle + " is out of range; give 5 to 90");
        }
        UsageException.requireWithin("--samples", samples == null ? 0 : samples, 0, MOST_SAMPLES);
        Energy rule = energy.choices().get(ENERGY);
        UsageException.throwIf(
                rule != Energy.SCALAR && !isSpectral(),
                "--energy conserve divides at each wavelength, and colors of a table have none: give --format bsdf, or npz with"
                        + " --channels spectral");
        double tolerance = asked.has(TOLERANCE) ? asked.get(TOLERANCE) : format.tolerance;
        Optional<String> shown = sceneName();
        long most = UsageException.parsed("--size ", () -> ByteSize.parse(size != null ? size : format.size(shown)));
        format.check(output, overwrite());
        PrintWriter err = err();
        long start = System.nanoTime();
        Optional<Scene> scene = shown.map(name -> SceneOverrides.apply(Scenes.load(name), asked.over(overrides())));
        scene.ifPresent(found -> WebScene.check(found, shown.get()));
        Optional<PageScene> page = scene.map(found -> page(found, shown.get(), most));
        TableWriter writer = writer(asked, tolerance, page);
        GridBaker.Limit limit = new GridBaker.Limit(writer, output, most);
        if (size != null) {
            limit.requireRoom(most);
        }
        Choices light =
                scene.map(found -> found.method().choices().without(TOLERANCE)).orElse(asked);
        Patch patch = page.map(PageScene::patch).orElseGet(() -> patchOptions.load(asked, environment(), err));
        DiffractionSetup setup = new DiffractionSetup(patch, environment(), err).withLight(LightTable.of(light));
        Choices choices =
                setup.limitToScan(light.with(Methods.METHOD, TableMethod.TYPE).with(AVERAGE, Average.ENSEMBLE), err);
        ColorTablePlan plan = new TableMethod(tolerance, GaussianArea.of(choices))
                .plan(setup.surface(), VisibleRange.all())
                .colorTable()
                .orElseThrow()
                .onRelief(scene.map(Scene::slopeDeviation).orElse(0.0));
        err.println("plan: " + plan.plan().summary() + "; a table of at most " + ByteSize.format(most));
        err.flush();
        GridBaker baker = new GridBaker(setup, plan);
        ColorGrid grid = baker.finest(Math.toRadians(largestAngle), limit);
        ColorGrid read = writer.asRead(grid);
        double width =
                Math.max(Energy.SHORTEST_WINDOW, read.level().area().window().coherenceLength());
        // The reference has no slopes.
        Optional<Integer> exact = baker.slopeDeviation() > 0 ? Optional.of(0) : Optional.ofNullable(samples);
        TableMetadata metadata = new TableMetadata(
                setup,
                choices,
                read,
                baker.slopeDeviation(),
                TableMetadata.GridErrors.of(
                        setup,
                        baker,
                        read,
                        writer.errorWeights(setup.cie()),
                        exact,
                        1e-9 * (System.nanoTime() - start)),
                rule.divisor(setup.patch().heights(), RefractiveIndex.KERATIN, choices.with(COHERENCE_LENGTH, width)));
        TableWriter.Output table = writer.output(grid, baker, metadata);
        List<Path> written = format.write(output, overwrite(), table.files());
        PrintWriter out = out(output);
        PrintWriter text = json.text(out);
        text.println(metadata.summary());
        text.println(metadata.error());
        table.notes().forEach(text::println);
        json.print(out, metadata.fields(), written);
        ErrorStatistics errors = table.errors();
        Certificate.Limits limits = Certificate.Limits.ofExport(tolerance);
        Certificate certificate = new Certificate(
                errors.pairs(), false, metadata.errors().quantity(), errors, ErrorStatistics.of(), limits);
        if (!certificate.missed()) {
            return ExitCode.OK.code();
        }
        err.println(Messages.error("the tolerance is missed: " + certificate.comparison()
                + "; give a finer --tolerance and, for room, a larger --size"));
        return ExitCode.TOLERANCE_MISSED.code();
    }

    /** Returns the options of the surface for a scene: its patch, too, unless --patch names the scene itself. */
    private Choices overrides() {
        Choices options = patchOptions.options();
        return sceneName == null && patchOptions.argument().isEmpty() ? options.without(PATCH) : options;
    }

    /**
     * Returns the scene that the page shows: of --scene, or PATCH that is no built-in patch, but a scene's name or file, of which
     * --patch replaces the patch.
     */
    private Optional<String> sceneName() {
        Optional<String> argument = patchOptions.argument();
        boolean replaced = patchOptions.options().has(PATCH);
        UsageException.throwIf(
                sceneName != null && argument.isPresent(),
                argument.map(name -> "'" + name + "' and --scene both name what is shown; give one of them")
                        .orElse(""));
        boolean both = replaced && argument.filter(ExportCommand::isScene).isPresent();
        UsageException.throwIf(
                both && format != Format.HTML,
                argument.map(name -> "--format " + format + " has no scene, which '" + name
                                + "' names beside --patch; leave it out, or give --format html")
                        .orElse(""));
        String named = sceneName != null || both ? "" : patchOptions.choices().get(PATCH, "");
        boolean isScene = !BuiltInPatches.names().contains(named) && isScene(named);
        Optional<String> scene =
                isScene ? Optional.of(named) : Optional.ofNullable(sceneName).or(() -> argument.filter(name -> both));
        scene.filter(name -> format != Format.HTML).ifPresent(name -> {
            throw new UsageException(
                    "'" + name + "' is a scene, which --format html shows; name its patch for " + format);
        });
        return scene;
    }

    private static boolean isScene(String named) {
        return Scenes.builtIn().contains(named) || (!named.isEmpty() && Scenes.isScene(Path.of(named)));
    }

    private PageScene page(Scene scene, String name, long most) {
        SceneLoader loader =
                new SceneLoader(environment(), warning -> err().println(Messages.warning(warning)), remark -> {});
        try (LoadingScene loading = new LoadingScene(loader, scene)) {
            return PageScene.of(loading, name, most);
        }
    }

    private boolean isSpectral() {
        return format == Format.BSDF || channels == NpzTable.Channels.SPECTRAL;
    }

    private TableWriter writer(Choices asked, double tolerance, Optional<PageScene> page) {
        if (channels != null && format != Format.NPZ) {
            throw new UsageException("--channels " + ValueKind.name(channels) + " is for --format npz, and " + format
                    + " has channels of its own; leave it out");
        }
        if (bands != null && !isSpectral()) {
            throw new UsageException("--bands is of --format bsdf, and of npz with --channels spectral; leave it out");
        }
        if (isSpectral()) {
            LightTable.requireNone(asked, List.of(MethodSettings.ILLUMINANT, MethodSettings.OBSERVER));
        }
        WavelengthBand range = asked.get(MethodSettings.WAVELENGTHS);
        return switch (format) {
            case NPZ -> {
                NpzTable.Channels kind = channels == null ? NpzTable.Channels.XYZ : channels;
                yield new NpzTable(kind, isSpectral() ? bands(range, bands == null ? BANDS : bands) : null);
            }
            case BSDF ->
                new BsdfTable(range, bands == null ? 0 : bands(range, bands).count());
            case HTML -> new HtmlTable(tolerance, page);
            case GLSL, OSL -> new FolderTable(format == Format.GLSL);
        };
    }

    private static SpectralBands bands(WavelengthBand range, int count) {
        return UsageException.parsed("--bands ", () -> new SpectralBands(range, count));
    }

    enum Format {
        NPZ("100MB", 0.02, Ending.NPZ),
        BSDF("100MB", 0.05, Ending.BSDF),
        HTML("1MB", 0.05, Ending.HTML),
        GLSL("50MB", 0.05, null),
        OSL("50MB", 0.05, null);

        private final String size;
        private final double tolerance;
        /** Ending of the file; null for a folder. */
        private final Ending ending;

        Format(String size, double tolerance, Ending ending) {
            this.size = size;
            this.tolerance = tolerance;
            this.ending = ending;
        }

        @Override
        public String toString() {
            return ValueKind.name(this);
        }

        String size(Optional<String> scene) {
            return scene.isPresent() ? SCENE_SIZE : size;
        }

        void check(Path output, Overwrite overwrite) {
            if (ending != null) {
                ending.require("--output", output);
                AtomicFile.checkWritable(output, overwrite);
                return;
            }
            OutputFolder.check(output);
            if (Files.isDirectory(output)) {
                group(output, overwrite).checkWritable();
            }
        }

        List<Path> write(Path output, Overwrite overwrite, Map<String, StreamContent> files) {
            return ending != null
                    ? List.of(AtomicFile.write(
                            output, overwrite, files.values().iterator().next()))
                    : OutputFolder.filled(output, () -> group(output, overwrite).write(files));
        }

        private FileGroup group(Path folder, Overwrite overwrite) {
            List<String> endings = this == GLSL
                    ? List.of(".glsl", ".hlsl", ".wgsl", ".ktx2", ".exr", ".html", ".md", ".json")
                    : List.of(".osl", ".exr", ".md", ".json");
            return new FileGroup(folder.resolve("sunbeam"), endings, overwrite);
        }
    }
}
