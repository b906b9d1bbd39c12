package sunbeam.app.brdf;

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
import sunbeam.app.accuracy.Certificate;
import sunbeam.app.accuracy.Certifier;
import sunbeam.app.cli.Environment;
import sunbeam.app.cli.ExitCode;
import sunbeam.app.cli.Messages;
import sunbeam.app.cli.Numbers;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.DiffractionMethod;
import sunbeam.app.gpu.FullMethod;
import sunbeam.app.gpu.MethodUse;
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.DefaultName;
import sunbeam.app.output.ForceOption;
import sunbeam.app.output.NpyWriter;
import sunbeam.app.output.Overwrite;
import sunbeam.app.output.PngWriter;
import sunbeam.app.output.SrgbImage;
import sunbeam.app.picture.AutoExposure;
import sunbeam.app.picture.DisplayPass;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.progress.Progress;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.LightOptions;
import sunbeam.app.setup.PatchOptions;
import sunbeam.app.setup.PlanOptions;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ReferenceColor;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** {@code sunbeam brdf-map}: from a height map to the picture of its BRDF. */
@Command(
        name = "brdf-map",
        description = "Draw the BRDF map of a surface: the colour that each direction of the hemisphere sees when light"
                + " comes from one direction. The pixel at (x, y) of the unit disc shows the direction (x, y,"
                + " sqrt(1 - x^2 - y^2)), +x right, +y up; the specular reflection of light from the normal lies in the"
                + " centre.")
public final class BrdfMapCommand implements Callable<Integer> {
    private static final int LARGEST = 8192;
    private static final int MOST_CERTIFIED = 100_000;
    private static final long CERTIFICATE_SEED = 1;

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private LightOptions light;

    @Mixin
    private PlanOptions planOptions;

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

    @Option(
            names = "--certify",
            paramLabel = "N",
            description = "Evaluate N random pixels of this very map with the exact reference and state its error:"
                    + " median, 95th percentile and maximum relative error of XYZ, and CIEDE2000. Exit code 3 when the"
                    + " median exceeds --tolerance or the 95th percentile three times it.")
    private Integer certify;

    @Spec
    private CommandSpec specification;

    public BrdfMapCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        if (size < 1 || size > LARGEST) {
            throw new UsageException("--size " + size + " is out of range; give 1 to " + LARGEST);
        }
        if (certify != null && (certify < 1 || certify > MOST_CERTIFIED)) {
            throw new UsageException("--certify " + certify + " is out of range; give 1 to " + MOST_CERTIFIED);
        }
        double fixedExposure = parseExposure();
        Direction wi = light.direction();
        PrintWriter err = specification.commandLine().getErr();
        DiffractionSetup setup = new DiffractionSetup(patchOptions, environment, err);
        Overwrite overwrite = force.overwrite();
        Path picture = output != null
                ? output
                : DefaultName.choose(Path.of(""), "brdf-" + setup.patch().name(), "png", overwrite);
        AtomicFile.checkWritable(picture, overwrite);
        if (linear != null) {
            AtomicFile.checkWritable(linear, overwrite);
        }
        Plan plan = setup.plan(planOptions.request(), VisibleRange.of(wi));
        PrintWriter out = specification.commandLine().getOut();
        planOptions.print(plan, out);
        Optional<Certificate> certificate;
        try (RenderContext context = RenderContexts.offscreen();
                DiffractionMethod method =
                        FullMethod.create(context, plan, setup.table(plan), MethodUse.COLOUR, setup.cie());
                BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size);
                DisplayPass display = new DisplayPass(context)) {
            LinearPicture map = render(renderer, wi);
            double factor = fixedExposure > 0 ? fixedExposure : AutoExposure.of(map, specular(wi, plan));
            certificate = certificate(setup, plan, wi, map, factor);
            Map<String, String> text = describe(setup, plan, factor, context);
            certificate.ifPresent(stated -> text.put("Certificate", stated.summary()));
            PngWriter.write(picture, overwrite, SrgbImage.fromEncoded(size, size, display.srgb(map, factor)), text);
            if (linear != null) {
                NpyWriter.write(linear, overwrite, map.xyz(), size, size, 3);
            }
        }
        out.println(picture);
        if (linear != null) {
            out.println(linear);
        }
        return certificate.map(this::judge).orElse(ExitCode.OK).code();
    }

    private double parseExposure() {
        if (exposure.equals("auto")) {
            return 0;
        }
        double value = Numbers.parse(exposure).orElse(Double.NaN);
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

    // The specular peak is as wide as the window's spectrum; five deviations of the longest wavelength hold all of it.
    private AutoExposure.Specular specular(Direction wi, Plan plan) {
        double radius = 5 * plan.window().sigmaFrequency() * 780e-9;
        DiscDirections directions = new DiscDirections(size, wi);
        return pixel -> directions.nearSpecular(pixel, radius);
    }

    /** Compares random pixels with the reference where that is asked for. */
    private Optional<Certificate> certificate(
            DiffractionSetup setup, Plan plan, Direction wi, LinearPicture map, double factor) {
        if (certify == null) {
            return Optional.empty();
        }
        ReferenceEvaluator evaluator = new ReferenceEvaluator(setup.patch().heights(), plan.window(), plan.origin());
        ReferenceColor color = new ReferenceColor(evaluator, plan.window(), setup.cie(), Quadrature.INTEGRATED);
        DiscDirections directions = new DiscDirections(size, wi);
        double tolerance = planOptions.request().tolerance();
        return Optional.of(new Certifier(color, plan.average() == Average.ENSEMBLE, directions::at)
                .certify(map, certify, CERTIFICATE_SEED, factor, tolerance));
    }

    /** Prints what the certificate says, and whether it will do. */
    private ExitCode judge(Certificate certificate) {
        specification.commandLine().getOut().println("certificate: " + certificate.summary());
        if (!certificate.missed()) {
            return ExitCode.OK;
        }
        specification.commandLine().getErr().println(Messages.error(certificate.complaint()));
        return ExitCode.TOLERANCE_MISSED;
    }

    private Map<String, String> describe(DiffractionSetup setup, Plan plan, double factor, RenderContext context) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "BRDF map of " + setup.patch().name());
        text.put("Patch", setup.patch().source());
        text.put("Light", light.describe());
        text.put("Method", "full");
        text.put("Options", planOptions.describe());
        text.put("Plan", new PlanReport(plan).summary());
        text.put("Exposure", Double.toString(factor));
        text.put("Renderer", context.info().renderer());
        return text;
    }
}
