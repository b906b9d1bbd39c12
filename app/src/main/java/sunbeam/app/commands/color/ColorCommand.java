package sunbeam.app.commands.color;

import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
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
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.gpu.picture.ExposureOption;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.ComparedPatches;
import sunbeam.app.terminal.options.LightOptions;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayColor;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** {@code sunbeam color}: the colour that a surface has from each side, as a picture and as numbers. */
@Command(
        name = "color",
        header = "Tell the colour of a surface from each viewing angle.",
        description =
                "Tell which colour is seen from each viewing angle, -80 to 80 degrees to the normal, in the plane of"
                        + " the direction along which the surface varies most (along) and in the plane at right angles to it"
                        + " (across); negative angles lie on the side away from that direction. Writes a picture with the strips"
                        + " of colours, the CIE 1931 diagram and spectra, and the numbers with their uncertainty as CSV and JSON"
                        + " beside it. See docs/color.md.")
public final class ColorCommand implements Callable<Integer> {
    private static final int MOST_LIGHTS = 31;
    private static final int MOST_SPECTRA = 6;
    private static final int WHITE = 0xffffff;

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private ComparedPatches compared;

    @Mixin
    private LightOptions light;

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
    private ExposureOption exposure;

    @Mixin
    private MethodOptions methodOptions;

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
        ExposureOption.Exposure exposed = exposure.parse();
        Methods.of(choices);
        PrintWriter err = specification.commandLine().getErr();
        List<ColorStrips> strips = compared.load(patchOptions, choices).stream()
                .map(patch -> new DiffractionSetup(patch, environment, err))
                .map(setup -> strips(setup, Methods.of(setup.seen(choices, err)), material))
                .toList();
        Path picture = output != null ? output : Path.of("color-" + names(strips) + ".png");
        List<Path> files = List.of(picture, sibling(picture, "csv"), sibling(picture, "json"));
        files.forEach(file -> AtomicFile.checkWritable(file, force.overwrite()));
        strips.forEach(strip -> methodOptions.print(strip.plan(), err));
        double tolerance = choices.get(TOLERANCE);
        CieTable cie = CieTable.load();
        List<ColorReport> reports = new ArrayList<>();
        double factor;
        String renderer;
        try (RenderContext context = RenderContexts.offscreen()) {
            renderer = context.info().renderer();
            List<List<double[]>> colours =
                    strips.stream().map(strip -> strip.colours(context)).toList();
            factor = exposed.of(colours.stream().map(ColorCommand::picture).toList());
            for (int i = 0; i < strips.size(); i++) {
                reports.add(report(context, strips.get(i), colours.get(i), factor, tolerance, material, cie));
            }
        }
        Choices seen = ScanLimit.of(choices, strips.get(0).setup().patch()).choices();
        Map<String, Object> settings = settings(seen, material, factor, tolerance, renderer);
        write(files, reports, settings, new ColorSheet(reports, factor, cie));
        PrintWriter out = specification.commandLine().getOut();
        reports.forEach(report -> out.println(summary(report)));
        files.forEach(out::println);
        return ExitCode.OK.code();
    }

    private void check() {
        Ending.PNG.require("--output", output);
        if (!(step >= 0.1 && step <= 10)) {
            throw new UsageException("--step " + step + " is out of range; give 0.1 to 10");
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

    private ColorStrips strips(DiffractionSetup setup, Method method, RefractiveIndex material) {
        Choices chosen = light.choices();
        OptionalDouble azimuth = chosen.has(LightOptions.PHI_I)
                ? OptionalDouble.of(Math.toDegrees(chosen.get(LightOptions.PHI_I)))
                : OptionalDouble.empty();
        return new ColorStrips(setup, method, material, azimuth, thetas(), step);
    }

    private List<Double> thetas() {
        double first = Math.toDegrees(light.choices().get(LightOptions.THETA_I));
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

    private static Path sibling(Path picture, String ending) {
        String name = picture.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return picture.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + "." + ending);
    }

    private static LinearPicture picture(List<double[]> colours) {
        float[] xyz = new float[3 * colours.size()];
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = (float) colours.get(i / 3)[i % 3];
        }
        return new LinearPicture(colours.size(), 1, xyz);
    }

    private ColorReport report(
            RenderContext context,
            ColorStrips strips,
            List<double[]> xyz,
            double factor,
            double tolerance,
            RefractiveIndex material,
            CieTable cie) {
        List<SeenColor> colours = new ArrayList<>();
        for (int i = 0; i < xyz.size(); i++) {
            colours.add(SeenColor.of(strips.views().get(i), xyz.get(i), factor, tolerance, strips.window(), cie));
        }
        double[] wavelengths = new double[401];
        for (int i = 0; i < wavelengths.length; i++) {
            wavelengths[i] = (380 + i) * 1e-9;
        }
        List<SeenColor.View> chosen = spectra.isEmpty()
                ? List.of(purest(colours).view())
                : spectra.stream()
                        .map(angle -> strips.view(true, thetas().get(0), angle))
                        .toList();
        List<double[]> radiances = strips.spectra(context, chosen, wavelengths, material);
        List<ColorReport.SeenSpectrum> seen = new ArrayList<>();
        for (int i = 0; i < chosen.size(); i++) {
            seen.add(new ColorReport.SeenSpectrum(chosen.get(i), wavelengths, radiances.get(i)));
        }
        return new ColorReport(
                strips.setup().patch().name(),
                strips.setup().patch().source(),
                strips.azimuthDegrees(),
                strips.lightAzimuthDegrees(),
                strips.window().coherenceLength(),
                strips.plan().summary(),
                thetas(),
                colours,
                seen);
    }

    /** The one of most chroma along, under the first light, of those that are not burnt out; else any. */
    private static SeenColor purest(List<SeenColor> colours) {
        double theta = colours.get(0).view().thetaIDegrees();
        return colours.stream()
                .filter(colour -> colour.view().along() && colour.view().thetaIDegrees() == theta)
                .filter(colour -> colour.rgb() != WHITE)
                .max(Comparator.comparingDouble(colour -> colour.lab().chroma()))
                .orElse(colours.get(0));
    }

    private static String summary(ColorReport report) {
        SeenColor purest = purest(report.colours());
        double wavelength = purest.hue().nanometres();
        String hue = Double.isNaN(wavelength)
                ? "no hue"
                : String.format(
                        Locale.ROOT,
                        wavelength > 0 ? "dominant wavelength %.0f nm" : "purple, complement of %.0f nm",
                        Math.abs(wavelength));
        return String.format(
                Locale.ROOT,
                "%s: strongest direction at azimuth %.1f degrees; purest colour %s (%s, chroma %.0f +- %.2g) at %.1f degrees;"
                        + " an order is %.2g nm wide there",
                report.name(),
                report.azimuthDegrees(),
                DisplayColor.hex(purest.rgb()),
                hue,
                purest.lab().chroma(),
                purest.uncertainty(),
                purest.view().thetaRDegrees(),
                purest.blurNanometres());
    }

    private Map<String, Object> settings(
            Choices choices, RefractiveIndex material, double factor, double tolerance, String renderer) {
        Map<String, Object> settings = new LinkedHashMap<>();
        settings.put("light", light.describe());
        settings.put("method", choices.get(METHOD).label());
        settings.put("options", Methods.describe(choices));
        settings.put("index", material.describe());
        settings.put("exposure", factor);
        settings.put("tolerance", tolerance);
        settings.put("renderer", renderer);
        return settings;
    }

    /** All files or none: none appears before all are written. */
    private void write(List<Path> files, List<ColorReport> reports, Map<String, Object> settings, ColorSheet sheet) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put(
                "Title", "Colours of " + reports.stream().map(ColorReport::name).collect(Collectors.joining(", ")));
        text.put("Patch", reports.stream().map(ColorReport::source).collect(Collectors.joining("; ")));
        settings.forEach((key, value) ->
                text.put(key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1), value.toString()));
        ObjectMapper json = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
        try (AtomicFile picture = AtomicFile.create(files.get(0), force.overwrite());
                AtomicFile csv = AtomicFile.create(files.get(1), force.overwrite());
                AtomicFile tree = AtomicFile.create(files.get(2), force.overwrite())) {
            picture.fill(stream -> PngWriter.write(stream, sheet.draw(), text));
            csv.fill(stream -> stream.write(ColorTables.csv(reports).getBytes(StandardCharsets.UTF_8)));
            tree.fill(stream -> stream.write(json.writeValueAsBytes(ColorTables.tree(reports, settings))));
            picture.commit();
            csv.commit();
            tree.commit();
        }
    }
}
