package sunbeam.app.commands.brdfmap;

import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.SrgbImage;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.app.gpu.map.DiscDirections;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.DisplayPass;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.measure.errors.Certificate;
import sunbeam.app.measure.errors.Certifier;
import sunbeam.app.measure.errors.CertifyOption;
import sunbeam.app.measure.errors.Explainer;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.LightOptions;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.units.Decimals;

/** {@code sunbeam brdf-map}: from a height map to the picture of its BRDF. */
@Command(
        name = "brdf-map",
        header = "Draw the BRDF map of a surface as a PNG.",
        description = "Draw the BRDF map of a surface: the colour that each direction of the hemisphere sees when light"
                + " comes from one direction. The pixel at (x, y) of the unit disc shows the direction (x, y,"
                + " sqrt(1 - x^2 - y^2)), +x right, +y up; the specular reflection of light from the normal lies in the"
                + " centre.")
public final class BrdfMapCommand implements Callable<Integer> {
    private static final int LARGEST = 8192;

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private LightOptions light;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private CertifyOption certify;

    @Mixin
    private ForceOption force;

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "256",
            description = "Width and height of the map. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Option(
            names = "--exposure",
            paramLabel = "FACTOR",
            defaultValue = "auto",
            description = "Factor for the linear colours, or auto (default): the diffracted light is well lit and the"
                    + " specular peak burns out.")
    private String exposure;

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description = "The picture, sRGB; it carries its parameters as text. Default: a name made of the patch.")
    private Path output;

    @Option(
            names = "--linear",
            paramLabel = "FILE.npy",
            description = "Also write the linear colours: float32, height x width x 3, row 0 on top, CIE XYZ of the"
                    + " relative radiance rho before exposure, NaN outside the disc.")
    private Path linear;

    @Spec
    private CommandSpec specification;

    public BrdfMapCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        Choices choices = methodOptions.choices();
        return choices.located(() -> draw(choices));
    }

    private int draw(Choices asked) {
        if (size < 1 || size > LARGEST) {
            throw new UsageException("--size " + size + " is out of range; give 1 to " + LARGEST);
        }
        Ending.PNG.require("--output", output);
        Ending.NPY.require("--linear", linear);
        double fixedExposure = parseExposure();
        certify.check(Methods.of(asked));
        Direction wi = light.direction();
        PrintWriter err = specification.commandLine().getErr();
        DiffractionSetup setup = new DiffractionSetup(patchOptions, asked, environment, err);
        Choices choices = setup.seen(asked, err);
        Method chosen = Methods.of(choices);
        Path picture = output != null ? output : Path.of("brdf-" + setup.patch().name() + ".png");
        AtomicFile.checkWritable(picture, force.overwrite(output));
        if (linear != null) {
            checkDifferent(picture);
            AtomicFile.checkWritable(linear, force.overwrite());
        }
        MethodPlan plan = chosen.plan(setup.surface(), VisibleRange.of(wi));
        PrintWriter out = StandardOutput.reports(specification.commandLine().getOut(), err, picture, linear);
        methodOptions.print(plan, err);
        ShaderTables tables = setup.tables(plan, MethodUse.COLOUR);
        Optional<Certificate> certificate;
        Path written;
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables method = UploadedTables.upload(context, tables);
                BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size);
                DisplayPass display = new DisplayPass(context)) {
            LinearPicture map = render(renderer, wi);
            DiscDirections directions = new DiscDirections(size, wi);
            double factor = fixedExposure > 0 ? fixedExposure : AutoExposure.of(map);
            certificate = certify.certificate(count -> new Certifier(setup.exact(chosen), directions::at)
                    .certify(map, count, CertifyOption.SEED, factor, choices.get(TOLERANCE)));
            Map<String, String> text = describe(setup, choices, plan.summary(), factor, context);
            certificate.ifPresent(stated -> text.put("Certificate", stated.summary()));
            BufferedImage image = SrgbImage.fromEncoded(size, size, display.srgb(map, factor));
            written = write(picture, stream -> PngWriter.write(stream, image, text), map);
        }
        out.println(written);
        if (linear != null) {
            out.println(linear);
        }
        return certificate
                .map(stated -> CertifyOption.judge(
                        stated, plan, new Explainer(setup, choices, VisibleRange.of(wi), MethodUse.COLOUR), out, err))
                .orElse(ExitCode.OK)
                .code();
    }

    private void checkDifferent(Path picture) {
        if (picture.toAbsolutePath().normalize().equals(linear.toAbsolutePath().normalize())) {
            throw new UsageException("--linear " + linear + " is the picture's own name; give it another");
        }
    }

    /** Both files or none: neither appears before both are written. */
    private Path write(Path picture, AtomicFile.StreamContent png, LinearPicture map) {
        try (AtomicFile image = AtomicFile.create(picture, force.overwrite(output));
                AtomicFile numbers = linear == null ? null : AtomicFile.create(linear, force.overwrite())) {
            image.fill(png);
            if (numbers != null) {
                numbers.fill(stream -> NpyWriter.write(stream, map.xyz(), size, size, 3));
                numbers.commit();
            }
            return image.commit();
        }
    }

    private double parseExposure() {
        if (exposure.equals("auto")) {
            return 0;
        }
        double value = Decimals.parse(exposure).orElse(Double.NaN);
        if (!(value > 0)) {
            throw new UsageException("--exposure '" + exposure + "' is neither auto nor a positive number");
        }
        return value;
    }

    private LinearPicture render(BrdfMapRenderer renderer, Direction wi) {
        try (Progress progress = Progress.start("BRDF map", (long) size * size)) {
            return renderer.render(wi, progress::step);
        }
    }

    private Map<String, String> describe(
            DiffractionSetup setup, Choices choices, String plan, double factor, RenderContext context) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "BRDF map of " + setup.patch().name());
        text.put("Patch", setup.patch().source());
        text.put("Light", light.describe());
        text.put("Method", choices.get(METHOD).label());
        text.put("Options", Methods.describe(choices));
        text.put("Plan", plan);
        text.put("Exposure", Double.toString(factor));
        text.put("Renderer", context.info().renderer());
        return text;
    }
}
