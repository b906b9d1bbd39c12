package sunbeam.app.cli;

import static sunbeam.app.scene.SceneSettings.ANGULAR_DIAMETER;
import static sunbeam.app.scene.SceneSettings.ENERGY;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.DisplayOptions.TevOption;
import sunbeam.app.cli.MaterialMap.MapSheet;
import sunbeam.app.cli.MaterialMap.Result;
import sunbeam.app.cli.PatchOptions.IndexOption;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.LinearFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.output.TevClient;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.PictureFile;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.Energy;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Angles;
import sunbeam.precompute.units.Decimals;

/** {@code sunbeam brdf-map}: draws the BRDF of a height map. */
@Command(
        name = "brdf-map",
        header = "Draw the BRDF map of a surface as a PNG.",
        description = "Draw the BRDF map of a surface: the color that each direction of the hemisphere sees when light"
                + " comes from one direction. The pixel at (x, y) of the unit disc shows the direction (x, y, sqrt(1 -"
                + " x^2 - y^2)), +x right, +y up; the specular reflection of light from the normal lies in the center.",
        footer = {
            "  sunbeam brdf-map blaze --theta-i 30",
            "  sunbeam brdf-map scan.png --width 65um --max-height 375nm --size 1024"
        })
public final class BrdfMapCommand extends FileCommand {
    private static final int LARGEST = 8192;

    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofMany();

    @Mixin
    private final SettingOptions turn = new SettingOptions(List.of(ROTATE_PATCH, ENERGY, ANGULAR_DIAMETER));

    @Mixin
    private LightOptions light;

    @Mixin
    private MethodOptions methodOptions = new MethodOptions(
            Map.of(MethodSettings.AVERAGE, "ensemble; coherent with a preset and for methods that have no other"));

    @Mixin
    private CertifyOption certify;

    @Mixin
    private ResumeOption resume;

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "512",
            description =
                    "Width and height of the map. From 1024 on most maps have method table unless another is given, at the"
                            + " same tolerance. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Mixin
    private IndexOption index;

    @Mixin
    private DisplayOptions exposure;

    @Mixin
    private PatchOptions.Compared compared;

    @Option(
            names = "--annotate",
            negatable = true,
            defaultValue = "true",
            fallbackValue = "true",
            description = "Draw around and over the map what a reader needs (default): the horizon, rings every 15"
                    + " degrees from the normal, the directions of light and mirror, and a caption with patch, light,"
                    + " coherence length and exposure. --no-annotate leaves the disc alone, --size pixels wide.")
    private boolean annotate;

    @Mixin
    private PageOptions page;

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description =
                    "The picture (.png, .pdf or .svg), sRGB; it carries its parameters as text. Of several patches: the folder."
                            + " Default: a name made of the patch.")
    private Path output;

    @Mixin
    private TevOption tev;

    @Option(
            names = "--linear",
            paramLabel = "FILE",
            description =
                    "Also write the linear colors, the relative radiance rho before exposure: FILE.npy, float32, height x"
                            + " width x 3, row 0 on top, CIE XYZ, NaN outside the disc; or FILE.exr, Rec. 709 and alpha.")
    private Path linear;

    // Whether large maps may have method table without the user's choice.
    private boolean mayChooseTable;

    /** A patch with its choices: a scan's size limits the coherence length. */
    private record Surface(DiffractionSetup setup, Choices choices) {}

    @Override
    public Integer call() {
        Choices choices = turn.choices().over(MethodOptions.averaged(methodOptions.choices()));
        mayChooseTable = LargeMap.mayHaveTable(size, choices);
        return choices.located(() -> {
            try {
                return draw(choices);
            } catch (LargeMap.TableMissed missed) {
                mayChooseTable = false;
                return draw(choices);
            }
        });
    }

    private Surface surface(DiffractionSetup setup, Choices choices, Direction towards) {
        Direction inPatch = towards.turned(-choices.get(ROTATE_PATCH));
        return Optional.of(choices)
                .filter(open -> mayChooseTable)
                .flatMap(open -> LargeMap.byTable(setup, open, inPatch))
                .map(byTable -> new Surface(LargeMap.strict(setup), byTable))
                .orElse(new Surface(setup, choices));
    }

    private int draw(Choices asked) {
        check();
        ToDoubleFunction<List<LinearPicture>> exposureRule = exposure.parse();
        certify.check(Methods.of(asked));
        RefractiveIndex material = material(asked);
        // All options are checked before scans are read.
        Direction towards = light.direction();
        Overwrite beforeResuming = resume.isGiven() ? Overwrite.REPLACE : overwrite();
        AtomicFile.checkWritable(output, beforeResuming);
        AtomicFile.checkWritable(linear, beforeResuming);
        PrintWriter err = err();
        CieTable spectrum = LightTable.of(asked);
        List<Surface> surfaces = compared
                .load(patchOptions, asked, environment().progress())
                .stream()
                .map(patch -> new DiffractionSetup(patch, environment(), err).withLight(spectrum))
                .map(setup -> surface(setup, setup.limitToScan(asked, err), towards))
                .toList();
        List<Patch> patches =
                surfaces.stream().map(surface -> surface.setup.patch()).toList();
        String names = patches.stream().map(Patch::name).limit(3).collect(Collectors.joining("-"));
        Path picture = output != null ? output : Path.of("brdf-" + names + ".png");
        PrintWriter out = out(picture, linear);
        String identity = resume.identity(patches);
        Optional<Integer> finished = resume.finished(identity, picture, linear, err);
        if (finished.isPresent()) {
            files(picture).forEach(out::println);
            return finished.get();
        }
        AtomicFile.checkWritable(picture, overwrite(resume.isGiven() ? picture : output));
        AtomicFile.checkWritable(linear, overwrite());
        List<MaterialMap> materials = surfaces.stream()
                .map(surface -> plan(surface, material, towards))
                .toList();
        MaterialMap firstMap = materials.get(0);
        Choices choices = surfaces.get(0).choices;
        List<Map<String, Object>> fields =
                json.isGiven() ? surfaces.stream().map(this::fields).toList() : List.of();
        Map<String, Object> report = new LinkedHashMap<>(Map.of("surfaces", fields));
        try (RenderContext context = RenderContext.offscreen();
                TevClient viewer = tev.connect(err).orElse(null)) {
            List<Result> maps =
                    materials.stream().map(one -> one.draw(context, size)).toList();
            maps.forEach(map -> methodOptions.printTrial(map.trial(), err));
            List<LinearPicture> pictures = maps.stream().map(Result::picture).toList();
            LinearPicture first = pictures.get(0);
            double factor = exposureRule.applyAsDouble(pictures);
            Optional<Certificate> certificate = certify.count().map(count -> firstMap.certify(first, count, factor));
            MapSheet sheet = new MapSheet(maps, exposure.display(factor, asked));
            Optional<Patch> black = sheet.black();
            String name = "the map" + black.map(patch -> " of " + patch.name()).orElse("");
            ExitCode doubt = doubt(sheet.patches(), black.isPresent(), name, exposure.isAutomatic(), err);
            Map<String, String> text = sheet.text();
            String wide = asked.has(ANGULAR_DIAMETER) ? ", " + asked.written(ANGULAR_DIAMETER) + " wide" : "";
            text.put("Light", light.describe() + wide);
            text.put("Patch turned", Angles.format(asked.get(ROTATE_PATCH)));
            text.put("Energy", asked.written(ENERGY));
            text.put("Method", choices.get(Methods.METHOD).label());
            text.put("Options", Methods.describe(choices));
            text.put("Index", index.describe(material));
            text.put("Renderer", context.info().renderer());
            certificate.ifPresent(stated -> text.put("Certificate", stated.summary()));
            ResumeOption.note(text, identity, doubt);
            String shared = compared.areSeveral() ? ", automatic, one for all" : ", automatic";
            String exposed = "exposure " + Decimals.rounded(factor, 3) + (exposure.isAutomatic() ? shared : "");
            Optional<String> other = Optional.of(index.describe(material)).filter(words -> !material.isStandard());
            Drawing drawing =
                    annotate ? sheet.annotated(other, exposed, asked, page.width()) : Drawing.of(sheet.plain());
            // Without annotation, a bitmap is transparent around the disc.
            StreamContent content = annotate || !Ending.ofPicture(picture).equals("png")
                    ? PictureFile.of(picture, drawing, page.width(), text)
                    : stream -> PngWriter.write(stream, sheet.plain(), text, drawing.width() / page.width());
            Path written = write(picture, content, text, first);
            List<Integer> thumbnail = List.of(0, 0, drawing.width(), drawing.width());
            fields.stream().limit(1).forEach(surface -> surface.put("thumbnail_px", thumbnail));
            report.put("exposure", factor);
            report.put("renderer", context.info().renderer());
            certificate.ifPresent(stated -> report.put("certificate", JsonOption.fields(stated)));
            if (viewer != null) {
                maps.forEach(map -> show(map, viewer));
            }
            json.print(out, report, files(written));
            if (isPlain()) {
                err.println("next: ./sunbeam view");
            }
            ExitCode certified = CertifyOption.judge(certificate, firstMap.plan(), choices, json.text(out), err);
            return (certified == ExitCode.OK ? doubt : certified).code();
        }
    }

    private List<Path> files(Path picture) {
        return linear == null ? List.of(picture) : List.of(picture, linear);
    }

    private void check() {
        UsageException.requireWithin("--size", size, 1, LARGEST);
        UsageException.throwIf(
                resume.isGiven() && (json.isGiven() || certify.count().isPresent()),
                "--resume keeps an existing map, " + (json.isGiven() ? "--json reports on it" : "--certify draws it")
                        + "; leave out one of them");
        Ending.PICTURE.require("--output", output);
        page.width();
        UsageException.throwIf(
                resume.isGiven() && output != null && !Ending.ofPicture(output).equals("png"),
                "--resume knows a finished map by its PNG; end --output with .png");
        Ending.LINEAR.require("--linear", linear);
        UsageException.throwIf(
                linear != null && linear.equals(output),
                "--linear " + linear + " is the picture's own name; give it another");
        UsageException.throwIf(
                certify.count().isPresent()
                        && turn.choices().get(ANGULAR_DIAMETER) > 0
                        && turn.choices().get(ENERGY) != Energy.SCALAR,
                "--certify divides the light of one direction; leave out --angular-diameter or --energy");
        UsageException.throwIf(
                compared.areSeveral() && (linear != null || certify.count().isPresent()),
                (linear != null ? "--linear" : "--certify")
                        + " is for one map; leave out --with, or draw the maps one by one, with"
                        + " --exposure FILE.png of the first");
    }

    /** Parses the refractive index. A certificate's exact colors are for an index that is constant over wavelengths. */
    private RefractiveIndex material(Choices asked) {
        RefractiveIndex material = index.parse();
        UsageException.throwIf(
                !material.isConstant() && certify.count().isPresent(),
                "--certify holds one integral against the reference, but an --index by wavelength takes"
                        + " two; give a number, or leave out --certify");
        FresnelFactor.requireFor(material, asked);
        return material;
    }

    private MaterialMap plan(Surface surface, RefractiveIndex material, Direction towards) {
        MaterialMap map = new MaterialMap(surface.setup, surface.choices, material, towards);
        String name = compared.areSeveral() ? surface.setup.patch().name() : "";
        boolean isChosen = mayChooseTable && surface.choices.has(Methods.METHOD);
        String reason = isChosen ? "; faster than method full for a large map" : "";
        methodOptions.print(name, map.plan(), map.summary() + reason, err());
        return map;
    }

    private Map<String, Object> fields(Surface surface) {
        double theta = light.degrees(LightOptions.THETA_I);
        Patch patch = surface.setup.patch();
        GratingPeriod period = cachedPeriod(patch).turned(surface.choices.get(ROTATE_PATCH));
        double phi = light.degrees(LightOptions.PHI_I);
        Verdict verdict = Verdict.of(patch, period, theta, phi - Math.toDegrees(period.azimuth()));
        Map<String, Object> fields = JsonOption.fields(patch, period, verdict);
        fields.put("theta_i_deg", theta);
        fields.put("phi_i_deg", phi);
        fields.put("method", surface.choices.get(Methods.METHOD).label());
        fields.put("options", Methods.describe(surface.choices));
        return fields;
    }

    private static void show(Result map, TevClient viewer) {
        String name = "BRDF of " + map.patch().name();
        LinearPicture picture = map.picture();
        viewer.create(name, picture.width(), picture.height());
        viewer.update(name, 0, 0, picture.width(), picture.height(), picture.xyz());
    }

    /** Writes the picture and, if requested, the linear file; neither appears under its name before both are complete. */
    private Path write(Path picture, StreamContent content, Map<String, String> text, LinearPicture map) {
        try (AtomicFile png = AtomicFile.create(picture, overwrite(resume.isGiven() ? picture : output));
                AtomicFile numbers = linear == null ? null : AtomicFile.create(linear, overwrite())) {
            if (numbers != null) {
                numbers.fill(LinearFile.of(linear, map.xyz(), size, size));
                ResumeOption.noteLinear(text, numbers.path());
            }
            png.fill(content);
            if (numbers != null) {
                numbers.commit();
            }
            return png.commit();
        }
    }
}
