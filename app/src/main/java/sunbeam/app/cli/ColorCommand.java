package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.PatchOptions.IndexOption;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.analysis.EnergyBalance;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/** Command {@code sunbeam color}: the color of a surface from each viewing angle, as a picture and as numbers. */
@Command(
        name = "color",
        header = "Tell the color of a surface from each viewing angle.",
        description = "Tell which color is seen from each viewing angle to the normal, in the plane in which"
                + " the surface spreads color, across the lines of its grating (along), and in the plane at right angles"
                + " to it (across). Angles are positive towards the plane's azimuth, where the light stands unless --phi-i"
                + " says otherwise: of crossed gratings each has its strip. Writes a picture and beside it the numbers as CSV and JSON; --explain also prints"
                + " the plan and all warnings. A surface without order has no color of its own: exit code 3. See"
                + " docs/color.md.",
        footer = {"  sunbeam color blaze --theta-i 30", "  sunbeam color scan.gwy --with other.gwy --output both.png"})
public final class ColorCommand extends FileCommand {
    private static final double HORIZON = 90;

    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofMany();

    @Mixin
    private PatchOptions.Compared compared;

    @Mixin
    private final SettingOptions turn = new SettingOptions(List.of(SceneSettings.ROTATE_PATCH));

    @Mixin
    private final LightOptions light = new LightOptions(
            Map.of(LightOptions.PHI_I, "that of each plane, so that the mirror direction lies in each strip"));

    @Mixin
    private IndexOption index;

    @Mixin
    private DisplayOptions exposure;

    @Mixin
    private final MethodOptions methodOptions = new MethodOptions(Map.of(MethodSettings.AVERAGE, "ensemble"));

    @Mixin
    private ResumeOption resume;

    @Mixin
    private PageOptions page;

    @Option(
            names = "--panel",
            paramLabel = "NAME",
            description = "Draw one panel alone: ${COMPLETION-CANDIDATES} (its values: .csv).")
    private ColorSheet.Panel panel;

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description =
                    "The picture (.png, .pdf or .svg); FILE.csv and FILE.json are written beside it. Of several patches: the folder."
                            + " Default: a name made of the patch.")
    private Path output;

    @Option(
            names = "--angles",
            paramLabel = "MIN:MAX:STEP",
            defaultValue = "-80:80:1",
            description = "Viewing angles in degrees. Each color is the mean over a step, 1 degree by default: what a"
                    + " pupil of 4 mm takes in 25 cm away. Default: ${DEFAULT-VALUE}.")
    private Range angles;

    @Override
    public Integer call() {
        // The ensemble average is the default: an eye or a camera sees many coherence areas at once.
        Choices choices = methodOptions.choices().over(Choices.none().with(MethodSettings.AVERAGE, Average.ENSEMBLE));
        Choices fitting = choices.get(Methods.METHOD).has(MethodSettings.AVERAGE) ? choices : methodOptions.choices();
        return fitting.located(() -> run(fitting));
    }

    private int run(Choices choices) {
        resume.requireMany();
        Ending.PICTURE.require("--output", output);
        page.width();
        double theta = light.degrees(LightOptions.THETA_I);
        UsageException.throwIf(
                angles.count() < 2 || Math.max(-angles.minimum(), angles.maximum()) + angles.step() / 2 >= HORIZON,
                "--angles: give two angles or more that lie, with half a step, within -90 to 90 degrees");
        RefractiveIndex material = index.parse();
        FresnelFactor.requireFor(material, choices);
        ToDoubleFunction<List<LinearPicture>> exposed = exposure.parse();
        Methods.of(choices);
        if (output != null) {
            files(output).checkWritable();
        }
        CieTable cie = LightTable.of(choices);
        List<Patch> patches = compared.load(patchOptions, choices, environment().progress());
        String names = patches.stream().map(Patch::name).limit(3).collect(Collectors.joining("-"));
        Path picture = output != null ? output : Path.of("color-" + names + ".png");
        FileGroup files = files(picture);
        files.checkWritable();
        List<String> warnings = new ArrayList<>();
        List<SurfaceColors> surfaces = patches.stream()
                .map(patch -> plan(patch, cie, choices, material, theta, warnings))
                .toList();
        Map<String, Object> settings;
        List<ColorReport> reports;
        try (RenderContext context = RenderContext.offscreen()) {
            surfaces.forEach(surface -> surface.draw(context));
            DisplayTransform display = exposure.display(factor(exposed, surfaces), choices);
            settings = describe(patches.get(0), choices, material, display);
            settings.put("renderer", context.info().renderer());
            reports = surfaces.stream()
                    .map(surface -> surface.report(context, display, choices.get(MethodSettings.TOLERANCE)))
                    .toList();
        }
        boolean black =
                reports.stream().anyMatch(report -> report.colors().stream().allMatch(color -> color.rgb() == 0));
        ExitCode judged = doubt(patches, black, "the picture", exposure.isAutomatic(), err());
        for (ColorReport report : reports) {
            String name = reports.size() > 1 ? Text.oneLine(report.patch().name()) + ": " : "";
            json.text(out()).println(name + String.join(System.lineSeparator() + "  ", report.lines()));
        }
        ColorSheet sheet = new ColorSheet(reports, settings, cie, page.pixels(), Optional.ofNullable(panel));
        Map<String, Object> tree = new LinkedHashMap<>(settings);
        List<Map<String, Object>> fields =
                reports.stream().map(ColorReport::fields).toList();
        fields.get(0).put("thumbnail_px", sheet.thumbnail());
        tree.put("surfaces", fields);
        tree.put("warnings", warnings);
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "Colors of " + patches.stream().map(Patch::name).collect(Collectors.joining("; ")));
        text.put("Patch", patches.stream().map(Patch::source).collect(Collectors.joining("; ")));
        settings.forEach((key, value) ->
                text.put(key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1), value.toString()));
        StreamContent csv = panel == ColorSheet.Panel.SPECTRUM ? sheet.spectraCsv() : ColorReport.csv(reports);
        write(files, tree, csv, sheet.draw(), page.width(), text);
        return (reports.stream().allMatch(ColorReport::colored) ? judged : ExitCode.TOLERANCE_MISSED).code();
    }

    private FileGroup files(Path picture) {
        String stem = FileNames.stem(picture);
        String ending = picture.getFileName().toString().substring(stem.length());
        return new FileGroup(picture.resolveSibling(stem), List.of(ending, ".csv", ".json"), overwrite(output));
    }

    private Map<String, Object> describe(
            Patch patch, Choices choices, RefractiveIndex material, DisplayTransform display) {
        Choices seen = ScanLimit.of(choices, patch).choices();
        Map<String, Object> settings = new LinkedHashMap<>();
        settings.put(
                "light",
                light.choices().has(LightOptions.PHI_I)
                        ? light.describe()
                        : "theta " + light.written(LightOptions.THETA_I) + " degrees, phi that of each strip's plane");
        settings.put("angle_step_deg", angles.step());
        settings.put("patch_turned_deg", Math.toDegrees(turn.choices().get(SceneSettings.ROTATE_PATCH)));
        settings.put("method", seen.get(Methods.METHOD).label());
        settings.put("options", Methods.describe(seen));
        settings.put("index", index.describe(material));
        settings.put("exposure", display.exposure());
        settings.put("tone", ValueKind.name(display.tone()));
        settings.put("primaries", ValueKind.name(display.primaries()));
        settings.put("tolerance", choices.get(MethodSettings.TOLERANCE));
        return settings;
    }

    /** Plans the method for a surface's views. Prints its warnings in one line, or with {@code --explain} in full. */
    private SurfaceColors plan(
            Patch patch,
            CieTable spectrum,
            Choices choices,
            RefractiveIndex material,
            double theta,
            List<String> warnings) {
        try (Progress progress = environment().progress().start("Planning " + patch.name(), 1)) {
            List<String> own = new ArrayList<>(patch.warnings());
            ScanLimit limit = ScanLimit.of(choices, patch);
            limit.line().ifPresent(line -> own.add(line.in(OptionOrigin.INSTANCE)));
            PrintWriter err = err();
            DiffractionSetup setup = new DiffractionSetup(patch, environment(), err).withLight(spectrum);
            Choices turned = turn.choices().over(light.choices());
            SurfaceColors surface =
                    new SurfaceColors(setup, cachedPeriod(patch), limit.choices(), material, turned, theta, angles);
            surface.energy().flatMap(EnergyBalance::warning).ifPresent(own::add);
            progress.step(1);
            if (methodOptions.explains()) {
                own.forEach(warning -> err.println(Messages.warning(patch.name() + ": " + warning)));
                methodOptions.print(patch.name(), surface.plan(), err);
            }
            surface.plan().warnings().forEach(line -> own.add(line.in(OptionOrigin.INSTANCE)));
            own.forEach(warning -> warnings.add(patch.name() + ": " + warning));
            if (!methodOptions.explains()) {
                Messages.scanWarning(patch.name(), own, "--explain").ifPresent(err::println);
            }
            return surface;
        }
    }

    /**
     * Returns the exposure for all surfaces; the automatic one is the geometric mean of theirs, so that a bright one leaves none black. Surfaces
     * without color count only if none has any.
     */
    private double factor(ToDoubleFunction<List<LinearPicture>> exposed, List<SurfaceColors> surfaces) {
        boolean colored = surfaces.stream().anyMatch(SurfaceColors::isColored);
        List<LinearPicture> pictures = surfaces.stream()
                .filter(surface -> surface.isColored() || !colored)
                .map(SurfaceColors::meteredColors)
                .toList();
        if (!exposure.isOfAll()) {
            return exposed.applyAsDouble(pictures);
        }
        return Math.exp(pictures.stream()
                .mapToDouble(picture -> Math.log(exposed.applyAsDouble(List.of(picture))))
                .average()
                .orElseThrow());
    }
}
