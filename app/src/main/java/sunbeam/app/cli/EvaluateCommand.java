package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.GratingPlane.FirstOrder;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.work.Progress;

/** Command {@code sunbeam evaluate}: compares a patch's response to light with the grating equation, as the thesis does in chapter 4. */
@Command(
        name = "evaluate",
        header = "Compare the light that a patch diffracts with the grating equation.",
        description = "Compare the light that a patch diffracts with the grating equation: tell the period of the"
                + " heights, compute the response over wavelengths and angles in the plane of incidence, and follow"
                + " the ridge of the first order. Writes the response (.csv), the figures (.json) and a plot (.png)."
                + " Methods table and gem compute colors only and are refused. See docs/evaluation.md.",
        footer = {"  sunbeam evaluate scan.gwy", "  sunbeam evaluate blaze --azimuth 0"})
public final class EvaluateCommand extends FileCommand {
    // Methods that compute power at a wavelength; gem and table compute colors only.
    private static final MethodType[] POWER = {FullMethod.TYPE, NmmMethod.TYPE, PqMethod.TYPE, ReferenceMethod.TYPE};
    // Factors around the period within which the ridge is searched. The period of a grown surface differs by a quarter
    // between coherence areas; that of a repeated patch is exact, and that of --period roughly known.
    private static final double GROWN_FACTOR = 1.35;
    private static final double EXACT_FACTOR = 1.1;
    private static final double GIVEN_FACTOR = 1.2;

    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofMany();

    @Mixin
    private ResumeOption resume;

    @Mixin
    private GratingOptions grating;

    @Mixin
    private final MethodOptions methodOptions = MethodOptions.of(POWER);

    @Mixin
    private PageOptions page;

    @Option(
            names = "--panel",
            paramLabel = "NAME",
            description = "Draw one panel alone, without heading: ${COMPLETION-CANDIDATES}.")
    private Evaluation.Panel panel;

    @Option(
            names = "--output",
            paramLabel = "NAME",
            description = "Name of the files; an ending .json or .csv is left out, as each file has its own; .png, .pdf"
                    + " or .svg is that of the plot. Default: PATCH-evaluate.")
    private Path output;

    @Override
    public Integer call() {
        resume.requireMany();
        Choices choices = methodOptions.choices();
        return choices.located(() -> evaluate(choices));
    }

    private int evaluate(Choices asked) {
        grating.check();
        page.width();
        Methods.of(asked);
        if (!Arrays.asList(POWER).contains(asked.get(Methods.METHOD))) {
            throw DiffractionSetup.withoutPower();
        }
        // A name that cannot be written is refused before the patch is read.
        if (output != null) {
            writableGroup(output, "");
        }
        PrintWriter out = json.text(out());
        Patch patch = patchOptions.load(asked);
        ScanLimit limit = ScanLimit.of(asked, patch);
        List<String> warnings = new ArrayList<>(patch.warnings());
        limit.line().ifPresent(line -> warnings.add(line.in(OptionOrigin.INSTANCE)));
        Messages.printScan(patch, warnings, methodOptions.explains(), err());
        FileGroup files = writableGroup(output, patch.name() + "-evaluate");
        Choices choices = limit.choices();
        GaussianArea area = GaussianArea.of(choices);
        GratingPeriod period = period(patch);
        GratingPlane plane = plane(patch, period);
        out.println(Evaluation.verdict(patch, period, plane).sentence());
        FirstOrder order = order(patch, period, plane);
        ResponseGrid grid = grating.grid(plane, order, area.window());
        DiffractionSetup setup =
                new DiffractionSetup(patch, environment(), line -> err().println(Messages.warning(line)));
        Optional<MethodPlan> plan = plan(setup, choices, grid);
        ResponseMatrix power =
                plan.isPresent() ? byShader(setup, plan.get(), grid) : exact(setup, Methods.of(choices), grid);
        Gain gain = new Gain(
                RefractiveIndex.KERATIN, Gain.R0, Methods.of(choices).fresnel().exponent());
        Evaluation evaluation =
                Evaluation.of(patch, period, order, power.toRelativeRadiance(gain), area.window(), grating.peaks());
        evaluation.lines(area.average(), methodOptions.explains()).forEach(out::println);
        Map<String, Object> report = report(evaluation, choices, plan);
        Drawing plot = evaluation.plot(title(choices), page.pixels(), panel != null);
        write(files, report, evaluation.csv(), plot, page.width(), text(evaluation, report));
        return period.isSeen() ? doubt(List.of(patch)).code() : ExitCode.UNUSABLE_INPUT.code();
    }

    private GratingPeriod period(Patch patch) {
        Optional<FirstOrder> given = givenOrder();
        double shortest = given.map(FirstOrder::shortest).orElse(0.0);
        double longest = given.map(FirstOrder::longest).orElse(Double.POSITIVE_INFINITY);
        try (Progress progress = environment().progress().start("Heights of " + patch.name(), 1)) {
            GratingPeriod period = GratingPeriod.among(patch, grating.azimuth(), shortest, longest);
            progress.step(1);
            return period;
        }
    }

    private Optional<FirstOrder> givenOrder() {
        return grating.period().map(period -> FirstOrder.around(period, GIVEN_FACTOR));
    }

    /** Without a period, the report is the verdict. */
    private FirstOrder order(Patch patch, GratingPeriod period, GratingPlane plane) {
        if (!period.isSeen() && givenOrder().isEmpty()) {
            boolean lost = grating.azimuth().isEmpty() && !period.hasWave();
            json.print(out(), JsonOption.fields(patch, period, Evaluation.verdict(patch, period, plane)), List.of());
            throw new InputException(patch.name() + ": no period is seen; to look for a ridge nevertheless, give "
                    + (lost ? "--azimuth and --period" : "--period"));
        }
        double factor = period.isExact() ? EXACT_FACTOR : GROWN_FACTOR;
        return givenOrder().orElseGet(() -> FirstOrder.around(period.period(), factor));
    }

    private GratingPlane plane(Patch patch, GratingPeriod period) {
        OptionalDouble azimuth = grating.azimuth();
        GratingPeriod aimed = period.hasWave() || azimuth.isPresent() ? period : cachedPeriod(patch);
        return grating.plane(azimuth.orElse(aimed.azimuth()));
    }

    private Optional<MethodPlan> plan(DiffractionSetup setup, Choices choices, ResponseGrid grid) {
        Optional<MethodPlan> plan = Optional.of(Methods.of(choices))
                .filter(method -> !(method instanceof ReferenceMethod))
                .map(method -> method.plan(setup.surface(), VisibleRange.of(grid.pairs())));
        plan.filter(made -> methodOptions.explains()).ifPresent(made -> methodOptions.print("", made, err()));
        return plan;
    }

    private static ResponseMatrix exact(DiffractionSetup setup, Method method, ResponseGrid grid) {
        ExactLight light = setup.exact(method);
        List<DirectionPair> pairs = grid.pairs();
        int columns = pairs.size();
        double[][] power = new double[grid.wavelengths().length][columns];
        int count = power.length * columns;
        try (Progress progress = setup.progress().start("Reference", count)) {
            IntStream.range(0, count).parallel().forEach(i -> {
                power[i / columns][i % columns] = light.power(pairs.get(i % columns), grid.wavelengths()[i / columns]);
                progress.step(1);
            });
        }
        return new ResponseMatrix(grid, power);
    }

    /** Evaluates by the shader that also draws BRDF maps, with a fragment for each direction and wavelength. */
    private static ResponseMatrix byShader(DiffractionSetup setup, MethodPlan plan, ResponseGrid grid) {
        ShaderTables tables = setup.tables(plan, MethodUse.SPECTRAL);
        double[] wavelengths = grid.wavelengths();
        double[][] power = new double[wavelengths.length][];
        long count = (long) wavelengths.length * grid.angles().length;
        try (RenderContext context = RenderContext.offscreen();
                UploadedTables uploaded = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = DirectionsRenderer.ofOnePower(context, uploaded);
                Progress progress = setup.progress().start("Response", count)) {
            for (int row = 0; row < wavelengths.length; row++) {
                double wavelength = wavelengths[row];
                List<DirectionQuery> queries = grid.pairs().stream()
                        .map(pair -> new DirectionQuery(pair, wavelength))
                        .toList();
                power[row] = renderer.evaluate(queries, progress::step).stream()
                        .mapToDouble(values -> values[0])
                        .toArray();
            }
        }
        return new ResponseMatrix(grid, power);
    }

    private Map<String, Object> report(Evaluation evaluation, Choices choices, Optional<MethodPlan> plan) {
        Map<String, Object> tree = evaluation.tree();
        GaussianArea area = GaussianArea.of(choices);
        tree.put("program", "Sunbeam " + Environment.version());
        tree.put("method", choices.get(Methods.METHOD).label());
        tree.put("options", Methods.describe(choices));
        plan.ifPresent(made -> tree.put("plan", made.summary()));
        tree.put("average", ValueKind.name(area.average()));
        tree.put("window_origin", ValueKind.name(area.origin()));
        tree.put("coherence_length_m", area.window().coherenceLength());
        return tree;
    }

    private static Map<String, String> text(Evaluation evaluation, Map<String, Object> tree) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", evaluation.patch().name() + ", " + evaluation.light());
        text.put("Patch", evaluation.patch().source());
        text.put("Method", tree.get("method").toString());
        text.put("Options", tree.get("options").toString());
        Optional.ofNullable(tree.get("plan")).ifPresent(plan -> text.put("Plan", plan.toString()));
        return text;
    }

    private String title(Choices choices) {
        MethodType method = choices.get(Methods.METHOD);
        return method.label()
                + (Preset.isThesis(choices) ? ", preset thesis" : "")
                + (method.equals(PqMethod.TYPE) ? ", " + ValueKind.name(PqMethod.interpolation(choices)) : "");
    }
}
