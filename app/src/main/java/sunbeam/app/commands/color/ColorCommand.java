package sunbeam.app.commands.color;

import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.IndexOption;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.gpu.picture.DisplayOptions;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.gpu.picture.ResumeOption;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.ComparedPatches;
import sunbeam.app.terminal.options.LightOptions;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.method.FittingPart;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Decimals;

/** {@code sunbeam color}: the color that a surface has from each side, as a picture and as numbers. */
@Command(
        name = "color",
        header = "Tell the color of a surface from each viewing angle.",
        description =
                "Tell which color is seen from each viewing angle, -80 to 80 degrees to the normal, in the plane in which"
                        + " the surface spreads most color (along) and in the plane at right angles to it (across). Angles are"
                        + " negative on the side away from the plane's azimuth, which need not be that of the grating that the"
                        + " first sentence names. Writes a picture and beside it the numbers as CSV and JSON; --explain also prints"
                        + " the plan and all warnings. A surface without order has no color of its own: exit code 3. See"
                        + " docs/color.md.")
public final class ColorCommand implements Callable<Integer> {
    private static final int MOST_LIGHTS = 31;
    private static final int MOST_SPECTRA = 6;

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private ComparedPatches compared;

    @Mixin
    private final LightOptions light = LightOptions.choosingAzimuth(
            "that of each surface's plane of most color, so that the mirror direction lies in the strip along");

    @Option(
            names = "--theta-i-to",
            paramLabel = "ANGLE",
            description =
                    "Light from --theta-i up to this angle to the normal in degrees, in steps of 5 or more: each strip"
                            + " then has a row a light.")
    private Double lastTheta;

    @Option(
            names = "--step",
            paramLabel = "ANGLE",
            defaultValue = "1",
            description = "Step of the viewing angle in degrees, 0.1 to 10. Default: ${DEFAULT-VALUE}.")
    private double step;

    @Option(
            names = "--spectrum",
            paramLabel = "ANGLE",
            split = ",",
            description =
                    "Viewing angles along, in degrees, at which to show the spectrum (first light). Default: where the"
                            + " color is purest.")
    private List<Double> spectra = new ArrayList<>();

    @Mixin
    private IndexOption index;

    @Mixin
    private DisplayOptions exposure;

    @Mixin
    private final MethodOptions methodOptions = MethodOptions.choosingAverage("ensemble");

    @Mixin
    private ForceOption force;

    @Mixin
    private ResumeOption resume;

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description =
                    "The picture; FILE.csv and FILE.json are written beside it. Default: a name made of the patch.")
    private Path output;

    @Spec
    private CommandSpec specification;

    public ColorCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        // An eye or a camera sees many coherence areas at once.
        Choices choices = methodOptions.choices().over(Choices.none().with(MethodSettings.AVERAGE, Average.ENSEMBLE));
        Choices fitting = choices.get(METHOD).has(MethodSettings.AVERAGE) ? choices : methodOptions.choices();
        return fitting.located(() -> tell(fitting));
    }

    private int tell(Choices choices) {
        check();
        RefractiveIndex material = index.parse();
        DisplayOptions.Exposure exposed = exposure.parse();
        exposure.tone(choices);
        Methods.of(choices);
        if (output != null) {
            new ColorFiles(output, resume.early(force.overwrite())).checkWritable();
        }
        PrintWriter err = specification.commandLine().getErr();
        Remarks remarks = new Remarks();
        List<Patch> patches = compared.load(patchOptions, choices);
        Path picture = output != null ? output : Path.of("color-" + names(patches) + ".png");
        ColorFiles files = new ColorFiles(picture, force.overwrite(resume.named(output, picture)));
        PrintWriter out = specification.commandLine().getOut();
        String identity = resume.identity(patches);
        OptionalInt finished = resume.finished(identity, picture, files.plainPaths(), err);
        if (finished.isPresent()) {
            files.plainPaths().forEach(out::println);
            return finished.getAsInt();
        }
        files.checkWritable();
        List<StripColors> strips = new ArrayList<>();
        for (Patch patch : patches) {
            strips.add(planned(patch, choices, material, remarks));
        }
        remarks.print(methodOptions.explains(), err);
        if (methodOptions.explains()) {
            strips.forEach(strip -> methodOptions.print(strip.setup().patch().name(), strip.plan(), err));
        }
        Map<String, Object> settings = new LinkedHashMap<>();
        List<ColorReport> reports;
        CieTable cie = CieTable.load();
        try (RenderContext context = RenderContexts.offscreen()) {
            reports = reports(context, strips, exposed, choices, material, cie, settings);
        }
        ExitCode judged = judge(reports, err);
        Map<String, String> note = new LinkedHashMap<>();
        ResumeOption.note(note, identity, judged);
        List<Path> written =
                files.write(reports, settings, remarks.all(), new ColorSheet(reports, settings, cie), note);
        for (ColorReport report : reports) {
            String name = reports.size() > 1 ? Quoted.oneLine(report.patch().name()) + ": " : "";
            out.println(name + String.join(System.lineSeparator() + "  ", report.lines()));
        }
        written.forEach(file -> out.println(StandardOutput.name(file)));
        return judged.code();
    }

    private static String names(List<Patch> patches) {
        return patches.stream().map(Patch::name).limit(3).collect(Collectors.joining("-"));
    }

    /** Draws, and notes what was drawn with. */
    private List<ColorReport> reports(
            RenderContext context,
            List<StripColors> strips,
            DisplayOptions.Exposure exposed,
            Choices choices,
            RefractiveIndex material,
            CieTable cie,
            Map<String, Object> settings) {
        List<Double> thetas = thetas();
        List<List<double[]>> colors =
                strips.stream().map(strip -> strip.colors(context)).toList();
        List<Verdict> verdicts = IntStream.range(0, strips.size())
                .mapToObj(i -> verdict(strips.get(i), colors.get(i)))
                .toList();
        List<LinearPicture> pictures = IntStream.range(0, strips.size())
                .mapToObj(i -> verdicts.get(i).colored()
                        ? strips.get(i).gloss().outside(strips.get(i).views(), colors.get(i))
                        : Gloss.picture(colors.get(i)))
                .toList();
        double factor = factor(exposed, pictures);
        DisplayTransform display = new DisplayTransform(factor, exposure.tone(choices));
        double tolerance = choices.get(TOLERANCE);
        Choices seen = ScanLimit.of(choices, strips.get(0).setup().patch()).choices();
        settings.put("light", light(strips));
        settings.put("method", seen.get(METHOD).label());
        settings.put("options", Methods.describe(seen));
        settings.put("index", index.describe(material));
        settings.put("exposure", factor);
        settings.put("tone", display.tone().name().toLowerCase(Locale.ROOT));
        settings.put("tolerance", tolerance);
        settings.put("renderer", context.info().renderer());
        ColorReport.Scale scale = new ColorReport.Scale(display, tolerance, cie);
        return IntStream.range(0, strips.size())
                .mapToObj(i -> ColorReport.of(
                        context, strips.get(i), colors.get(i), verdicts.get(i), thetas, spectra, material, scale))
                .toList();
    }

    private Verdict verdict(StripColors strips, List<double[]> colors) {
        Gloss gloss = strips.gloss();
        boolean allGloss = IntStream.range(0, colors.size())
                .noneMatch(i -> gloss.leaves(strips.views().get(i), colors.get(i)));
        return Verdict.of(
                strips.setup().patch(),
                strips.order(),
                strips.light(thetas().get(0)),
                gloss.window().coherenceLength(),
                allGloss);
    }

    private ExitCode judge(List<ColorReport> reports, PrintWriter err) {
        boolean black =
                reports.stream().anyMatch(report -> report.colors().stream().allMatch(color -> color.rgb() == 0));
        List<Patch> patches = reports.stream().map(ColorReport::patch).toList();
        ExitCode judged = DoubtfulPicture.judge(patches, black, "the picture", exposure.isAutomatic(), err);
        return reports.stream().allMatch(report -> report.verdict().colored()) ? judged : ExitCode.TOLERANCE_MISSED;
    }

    private void check() {
        Ending.PNG.require("--output", output);
        if (!(step >= 0.1 && step <= 10)) {
            throw new UsageException("--step " + Decimals.format(step) + " is out of range; give 0.1 to 10");
        }
        double first = Math.toDegrees(light.choices().get(LightOptions.THETA_I));
        if (lastTheta != null && !(lastTheta > first && lastTheta < 90)) {
            throw new UsageException(
                    "--theta-i-to " + lastTheta + " is out of range; give more than --theta-i and less than 90");
        }
        if (spectra.size() > MOST_SPECTRA) {
            throw new UsageException("--spectrum has " + spectra.size() + " angles; give " + MOST_SPECTRA + " at most");
        }
        for (double angle : spectra) {
            if (!(Math.abs(angle) <= StripColors.LARGEST_VIEW_DEGREES)) {
                throw new UsageException("--spectrum " + angle + " is out of range; give -80 to 80");
            }
        }
    }

    /**
     * Lays out and plans what is seen of a surface.
     *
     * @throws SettingException where that takes too much; it says which part of the surface can be drawn
     */
    private StripColors planned(Patch patch, Choices choices, RefractiveIndex material, Remarks remarks) {
        try (Progress progress = Progress.start("Planning " + patch.name(), 1)) {
            patch.warnings().forEach(warning -> remarks.add(patch.name(), warning));
            ScanLimit limit = ScanLimit.of(choices, patch);
            limit.line().ifPresent(line -> remarks.add(patch.name(), line.in(OptionOrigin.INSTANCE)));
            StripColors strips = strips(patch, limit.choices(), material);
            strips.plan().warnings().forEach(line -> remarks.add(patch.name(), line.in(OptionOrigin.INSTANCE)));
            progress.step(1);
            return strips;
        } catch (SettingException tooMuch) {
            throw FittingPart.of(
                            patch,
                            part -> strips(part, ScanLimit.of(choices, part).choices(), material))
                    .map(part -> tooMuch.and(part.sentence(patch)))
                    .orElse(tooMuch);
        }
    }

    private StripColors strips(Patch patch, Choices seen, RefractiveIndex material) {
        PrintWriter err = specification.commandLine().getErr();
        DiffractionSetup setup = new DiffractionSetup(patch, environment, warning -> {
            err.println(Messages.warning(warning));
            err.flush();
        });
        Choices chosen = light.choices();
        OptionalDouble azimuth = chosen.has(LightOptions.PHI_I)
                ? OptionalDouble.of(Math.toDegrees(chosen.get(LightOptions.PHI_I)))
                : OptionalDouble.empty();
        return new StripColors(setup, Methods.of(seen), material, azimuth, thetas(), step);
    }

    private List<Double> thetas() {
        // As it was typed: radians and back spoil the last digits.
        double first = Double.parseDouble(light.written(LightOptions.THETA_I));
        if (lastTheta == null) {
            return List.of(first);
        }
        int steps = (int) Math.min(MOST_LIGHTS - 1, Math.max(1, Math.round((lastTheta - first) / 5)));
        List<Double> thetas = new ArrayList<>();
        for (int i = 0; i <= steps; i++) {
            thetas.add(first + i * (lastTheta - first) / steps);
        }
        return thetas;
    }

    /** Of several surfaces each counts alike, lest a bright one leaves the others black: the mean of their logarithms. */
    private double factor(DisplayOptions.Exposure exposed, List<LinearPicture> pictures) {
        if (!exposure.isOfAll()) {
            return exposed.of(pictures);
        }
        return Math.exp(pictures.stream()
                .mapToDouble(picture -> Math.log(exposed.of(picture)))
                .average()
                .orElseThrow());
    }

    /** For metadata: where the light stood. */
    private String light(List<StripColors> strips) {
        String theta = light.written(LightOptions.THETA_I);
        if (lastTheta != null) {
            theta += " to " + Decimals.format(lastTheta) + " in " + (thetas().size() - 1) + " steps";
        }
        if (light.choices().has(LightOptions.PHI_I)) {
            return "theta " + theta + ", phi " + light.written(LightOptions.PHI_I) + " degrees";
        }
        String azimuths = strips.stream()
                .map(strip -> String.format(
                        Locale.ROOT, "%s %.1f", strip.setup().patch().name(), strip.lightAzimuthDegrees() + 0.0))
                .collect(Collectors.joining(", "));
        return "theta " + theta + " degrees, phi that of each surface's plane of most color: " + azimuths + " degrees";
    }
}
