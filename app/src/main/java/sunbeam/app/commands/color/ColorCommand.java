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
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
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
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.HeardWarnings;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.ComparedPatches;
import sunbeam.app.terminal.options.LightOptions;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.FittingPart;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Decimals;

/** {@code sunbeam color}: the colour that a surface has from each side, as a picture and as numbers. */
@Command(
        name = "color",
        header = "Tell the colour of a surface from each viewing angle.",
        description =
                "Tell which colour is seen from each viewing angle, -80 to 80 degrees to the normal, in the plane of"
                        + " the direction in which the surface spreads most colour (along) and in the plane at right angles to it"
                        + " (across); negative angles lie on the side away from that direction, which is across the lines of a"
                        + " grating and need not be that of the period which inspect tells. Writes a picture with the strips"
                        + " of colours, the CIE 1931 diagram and spectra, and the numbers with their uncertainty as CSV and JSON"
                        + " beside it. The purest colour is that along, at every degree under the first light, with the largest"
                        + " product of excitation purity and lightness (at most that of white), whatever --exposure and --step"
                        + " are. Neither it nor the automatic exposure regards the mirror's surroundings: |(u, v)| up to 0.156,"
                        + " or as far as a shorter coherence length spreads them. See docs/color.md.")
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
            "that of each surface's direction of most colour, so that the mirror direction lies in the strip along");

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
                            + " colour is purest.")
    private List<Double> spectra = new ArrayList<>();

    @Mixin
    private IndexOption index;

    @Mixin
    private DisplayOptions exposure;

    @Mixin
    private final MethodOptions methodOptions = MethodOptions.choosingAverage("ensemble");

    @Mixin
    private ForceOption force;

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
        Methods.of(choices);
        if (output != null) {
            new ColorFiles(output, force.overwrite()).checkWritable();
        }
        HeardWarnings heard = new HeardWarnings(specification.commandLine().getErr());
        PrintWriter err = heard.printer();
        List<ColorStrips> strips = compared.load(patchOptions, choices).stream()
                .map(patch -> new DiffractionSetup(patch, environment, err))
                .map(setup -> told(setup, choices, material, err))
                .toList();
        Path picture = output != null ? output : Path.of("color-" + names(strips) + ".png");
        ColorFiles files = new ColorFiles(picture, force.overwrite(output));
        files.checkWritable();
        if (strips.size() > 1) {
            strips.forEach(strip -> methodOptions.print(strip.setup().patch().name(), strip.plan(), err));
        } else {
            methodOptions.print(strips.get(0).plan(), err);
        }
        double tolerance = choices.get(TOLERANCE);
        CieTable cie = CieTable.load();
        List<ColorReport> reports = new ArrayList<>();
        double factor;
        String renderer;
        try (RenderContext context = RenderContexts.offscreen()) {
            renderer = context.info().renderer();
            List<ColorStrips.Colours> colours =
                    strips.stream().map(strip -> strip.colours(context)).toList();
            factor = factor(exposed, pictures(strips, colours));
            ColorReports told = new ColorReports(thetas(), spectra, factor, tolerance, material, cie);
            for (int i = 0; i < strips.size(); i++) {
                reports.add(told.of(context, strips.get(i), colours.get(i)));
            }
        }
        Choices seen = ScanLimit.of(choices, strips.get(0).setup().patch()).choices();
        Map<String, Object> settings = new LinkedHashMap<>();
        settings.put("light", light(strips));
        settings.put("method", seen.get(METHOD).label());
        settings.put("options", Methods.describe(seen));
        settings.put("index", index.describe(material));
        settings.put("exposure", factor);
        settings.put("tolerance", tolerance);
        settings.put("renderer", renderer);
        ExitCode judged = judge(reports, strips, choices, err);
        List<Path> written = files.write(reports, settings, heard.all(), new ColorSheet(reports, settings, cie));
        PrintWriter out = specification.commandLine().getOut();
        reports.forEach(report -> out.println(ColorSummary.of(report)));
        written.forEach(file -> out.println(StandardOutput.name(file)));
        return judged.code();
    }

    /** Warns of what can only be a mistake. */
    private ExitCode judge(List<ColorReport> reports, List<ColorStrips> strips, Choices choices, PrintWriter err) {
        boolean black = reports.stream()
                .anyMatch(report -> report.colours().stream()
                        .allMatch(colour -> colour.shown().rgb() == 0));
        List<Patch> patches =
                strips.stream().map(strip -> strip.setup().patch()).toList();
        boolean tooSmall = false;
        for (int i = 0; i < patches.size(); i++) {
            tooSmall |= SmallScan.judge(reports.get(i), patches.get(i), choices, err);
        }
        ExitCode judged = DoubtfulPicture.judge(patches, black, "the picture", exposure.isAutomatic(), err);
        return tooSmall ? ExitCode.TOLERANCE_MISSED : judged;
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
            if (!(Math.abs(angle) <= ColorStrips.LARGEST_VIEW_DEGREES)) {
                throw new UsageException("--spectrum " + angle + " is out of range; give -80 to 80");
            }
        }
    }

    private ColorStrips told(DiffractionSetup setup, Choices choices, RefractiveIndex material, PrintWriter err) {
        try (Progress progress = Progress.start("Planning " + setup.patch().name(), 1)) {
            ColorStrips strips = strips(setup, choices, material, err);
            progress.step(1);
            return strips;
        }
    }

    /**
     * Lays out and plans what is seen of a surface.
     *
     * @throws SettingException where that takes too much; it says which part of the surface can be drawn
     */
    private ColorStrips strips(DiffractionSetup setup, Choices choices, RefractiveIndex material, PrintWriter err) {
        Choices seen = setup.seen(choices, err);
        try {
            ColorStrips strips = strips(setup, Methods.of(seen), material);
            for (String line : LevellingAdvice.of(setup.patch(), strips.direction())) {
                err.println(Messages.warning(setup.patch().name() + ": " + line));
            }
            err.flush();
            return strips;
        } catch (SettingException tooMuch) {
            Patch patch = setup.patch();
            throw FittingPart.of(patch, part -> tryStrips(part, choices, material))
                    .map(part -> tooMuch.and(part.sentence(patch)))
                    .orElse(tooMuch);
        }
    }

    private void tryStrips(Patch part, Choices choices, RefractiveIndex material) {
        DiffractionSetup setup = new DiffractionSetup(part, environment, warning -> {});
        strips(setup, Methods.of(ScanLimit.of(choices, part).choices()), material);
    }

    private ColorStrips strips(DiffractionSetup setup, Method method, RefractiveIndex material) {
        Choices chosen = light.choices();
        OptionalDouble azimuth = chosen.has(LightOptions.PHI_I)
                ? OptionalDouble.of(Math.toDegrees(chosen.get(LightOptions.PHI_I)))
                : OptionalDouble.empty();
        return new ColorStrips(setup, method, material, azimuth, thetas(), step);
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

    private static String names(List<ColorStrips> strips) {
        return strips.stream()
                .map(strip -> strip.setup().patch().name())
                .limit(3)
                .collect(Collectors.joining("-"));
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

    /** What the exposure is chosen from: what the mirror leaves, unless it leaves nothing of any surface. */
    private static List<LinearPicture> pictures(List<ColorStrips> strips, List<ColorStrips.Colours> colours) {
        List<LinearPicture> outside = new ArrayList<>();
        List<LinearPicture> all = new ArrayList<>();
        for (int i = 0; i < strips.size(); i++) {
            ColorStrips strip = strips.get(i);
            outside.add(strip.reach().outside(strip.views(), colours.get(i).shown()));
            all.add(MirrorReach.picture(colours.get(i).shown()));
        }
        outside.removeIf(picture -> picture.width() == 0);
        return outside.isEmpty() ? all : outside;
    }

    /** For metadata: where the light stood. */
    private String light(List<ColorStrips> strips) {
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
        return "theta " + theta + " degrees, phi that of each surface's direction of most colour: " + azimuths
                + " degrees";
    }
}
