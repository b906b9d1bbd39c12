package sunbeam.app.commands.evaluate;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.app.gpu.picture.ResumeOption;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ScanWarnings;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.Version;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.Choices;

/** {@code sunbeam evaluate}: a patch's period from its response, as in the thesis's chapter 4. */
@Command(
        name = "evaluate",
        header = "Measure a patch's period by the light it diffracts.",
        description = "Measure a patch's period by the light it diffracts: compute the response over wavelengths and"
                + " angles in the plane of incidence, follow the ridge of the first order, and fit the grating equation."
                + " Writes the matrix (.csv and .npy), the figures (.json) and a plot (.png). See"
                + " docs/evaluation.md.")
public final class EvaluateCommand implements Callable<Integer> {
    private static final int MOST_POSITIONS = 10_000;
    private static final List<String> ENDINGS = List.of(".png", ".json", ".csv", ".npy");

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private GratingOptions gratingOptions;

    @Mixin
    private final MethodOptions methodOptions = MethodOptions.of(FullMethod.TYPE);

    @Mixin
    private ForceOption force;

    @Mixin
    private ResumeOption resume;

    @Option(
            names = "--method",
            paramLabel = "METHOD",
            defaultValue = "full",
            converter = ResponseMethodConverter.class,
            description = "full (default): one fragment for each angle and wavelength, through the shader code that"
                    + " draws the maps. nmm, pq: the thesis's other methods. bins: the sums of full in double precision"
                    + " on the processor. reference: direct sums over the surface; exact, for a few hundred"
                    + " directions.")
    private ResponseMethod method;

    @Option(
            names = "--quantity",
            paramLabel = "QUANTITY",
            defaultValue = "rho",
            description = "rho (default): relative radiance, what a map shows. power: the diffracted power alone.")
    private Quantity quantity;

    @Option(
            names = "--positions",
            paramLabel = "N",
            defaultValue = "0",
            description = "Also evaluate N random positions of the coherence window (by method bins) and the mean over"
                    + " all positions, and tell how the period is distributed; where there is a ridge.")
    private int positions;

    @Option(
            names = "--seed",
            paramLabel = "NUMBER",
            defaultValue = "1",
            description = "Seed of the random positions. Default: ${DEFAULT-VALUE}.")
    private long seed;

    @Option(
            names = "--output",
            paramLabel = "NAME",
            description =
                    "What the files are called; an ending .png, .json, .csv or .npy is left out, as each file has its"
                            + " own. Default: a name made of the patch.")
    private Path output;

    @Spec
    private CommandSpec specification;

    public EvaluateCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        Choices choices = methodOptions.choices();
        return choices.located(() -> evaluate(choices));
    }

    private int evaluate(Choices asked) {
        gratingOptions.request();
        method.of(asked);
        if (positions < 0 || positions > MOST_POSITIONS) {
            throw new UsageException("--positions " + positions + " is out of range; give 0 to " + MOST_POSITIONS);
        }
        if (output != null) {
            new FileGroup(stem(output), endings(), resume.early(force.overwrite())).checkWritable();
        }
        PrintWriter err = specification.commandLine().getErr();
        Patch patch = patchOptions.load(asked);
        ScanLimit limit = ScanLimit.of(method.in(asked), patch);
        warn(patch, limit, err);
        DiffractionSetup setup = new DiffractionSetup(patch, environment, warning -> warn(warning, err));
        Path stem = output != null ? stem(output) : Path.of(setup.patch().name() + "-evaluate");
        FileGroup files = new FileGroup(stem, endings(), force.overwrite(resume.named(output, stem)));
        String identity = resume.identity(List.of(setup.patch()));
        OptionalInt finished = resume.finished(
                identity,
                files.plainPaths().get(0),
                files.plainPaths(),
                specification.commandLine().getErr());
        if (finished.isPresent()) {
            files.plainPaths().forEach(specification.commandLine().getOut()::println);
            return finished.getAsInt();
        }
        files.checkWritable();
        return evaluate(
                        setup,
                        limit.choices(),
                        files,
                        identity,
                        specification.commandLine().getOut())
                .code();
    }

    /** Notes, and all warnings in one line. */
    private void warn(Patch patch, ScanLimit limit, PrintWriter err) {
        patch.notes().forEach(note -> err.println(Messages.note(patch.name() + ": " + note)));
        List<String> warnings = new ArrayList<>(patch.warnings());
        limit.line().ifPresent(line -> warnings.add(line.in(OptionOrigin.INSTANCE)));
        if (methodOptions.explains()) {
            warnings.forEach(warning -> err.println(Messages.warning(patch.name() + ": " + warning)));
        } else {
            ScanWarnings.line(patch.name(), warnings, "--explain").ifPresent(err::println);
        }
        err.flush();
    }

    private static void warn(String warning, PrintWriter err) {
        err.println(Messages.warning(warning));
        err.flush();
    }

    /** What all files are called whose endings follow, also where one of the endings was given. */
    static Path stem(Path named) {
        String name = String.valueOf(named.getFileName());
        return ENDINGS.stream()
                .filter(ending -> name.endsWith(ending) && name.length() > ending.length())
                .findFirst()
                .map(ending -> named.resolveSibling(name.substring(0, name.length() - ending.length())))
                .orElse(named);
    }

    private List<String> endings() {
        List<String> all = new ArrayList<>(ENDINGS);
        if (positions > 0) {
            all.addAll(List.of("-positions.csv", "-positions.png"));
        }
        return all;
    }

    private ExitCode evaluate(
            DiffractionSetup setup, Choices choices, FileGroup files, String identity, PrintWriter out) {
        PrintWriter err = specification.commandLine().getErr();
        Evaluation evaluation = Evaluation.of(
                setup,
                gratingOptions.request(),
                choices,
                method,
                quantity,
                planned -> {
                    if (methodOptions.explains()) {
                        methodOptions.print(planned, err);
                    }
                },
                line -> {
                    err.println(Messages.note(line));
                    err.flush();
                });
        GratingTarget target = evaluation.target();
        Map<String, Object> report = describe(setup, choices, evaluation);
        String verdict = Verdict.of(setup.patch(), target.heights());
        report.put("verdict", verdict);
        report.put("period", target.told().map(EvaluationReport::tree).orElse(null));
        report.put("period_not_told", target.doubt().isEmpty() ? null : target.doubt());
        report.put("ridge_left_out", evaluation.noRidge().orElse(null));
        evaluation.measurement().map(EvaluationReport::tree).ifPresent(report::putAll);
        String title = evaluation.title();
        out.println(verdict);
        out.println(title);
        out.println(EvaluationReport.line(target));
        String area = Evaluation.area(choices);
        out.println(evaluation
                .measurement()
                .map(found -> EvaluationReport.ridgeLine(found, target.told().isPresent(), area))
                .orElseGet(() -> "ridge       left out: " + evaluation.noRidge().orElseThrow()));
        evaluation
                .measurement()
                .filter(found -> methodOptions.explains())
                .map(EvaluationReport::lines)
                .ifPresent(lines -> lines.forEach(out::println));
        out.flush();
        Map<String, AtomicFile.StreamContent> contents = new LinkedHashMap<>();
        if (positions > 0 && evaluation.measurement().isPresent()) {
            Positions.Draw draw = new Positions.Draw(
                    positions,
                    seed,
                    setup.surface().identity().columns(),
                    setup.surface().identity().rows());
            Positions all = Positions.measure(
                    evaluation.responses().binSums(),
                    draw,
                    quantity,
                    target.order(),
                    GaussianArea.windowOf(choices).sigmaFrequency());
            report.put("positions", EvaluationReport.tree(all, seed));
            EvaluationReport.lines(all).forEach(out::println);
            contents.put("-positions.csv", PositionFiles.csv(all));
            if (all.sorted().length > 0) {
                Map<String, String> text = text(setup, choices, title, ResponseMethod.BINS);
                contents.put(
                        "-positions.png",
                        stream -> PngWriter.write(stream, PositionFiles.draw(evaluation.figureTitle(), all), text));
            }
        }
        contents.put(".csv", MatrixFiles.csv(evaluation.response()));
        contents.put(".npy", MatrixFiles.npy(evaluation.response()));
        contents.put(
                ".json",
                stream -> stream.write(
                        new ObjectMapper().writerWithDefaultPrettyPrinter().writeValueAsBytes(report)));
        Map<String, String> text = text(setup, choices, title, method);
        evaluation.plan().ifPresent(plan -> text.put("Plan", plan));
        ExitCode code =
                target.told().isPresent() ? DoubtfulPicture.ofPatches(List.of(setup.patch())) : ExitCode.UNUSABLE_INPUT;
        ResumeOption.note(text, identity, code);
        contents.put(".png", stream -> PngWriter.write(stream, evaluation.plot(), text));
        files.write(contents).forEach(file -> out.println(StandardOutput.name(file)));
        return code;
    }

    private Map<String, Object> describe(DiffractionSetup setup, Choices choices, Evaluation evaluation) {
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("program", "Sunbeam " + Version.number());
        report.put("patch", setup.patch().name());
        report.put("source", setup.patch().source());
        report.put("method", method.label());
        report.put("quantity", quantity.name().toLowerCase(Locale.ROOT));
        report.put("options", Methods.describe(method.in(choices)));
        evaluation.plan().ifPresent(plan -> report.put("plan", plan));
        GaussianArea area = GaussianArea.of(choices);
        report.put("average", area.average().name().toLowerCase(Locale.ROOT));
        report.put("window_origin", area.origin().name().toLowerCase(Locale.ROOT));
        report.put("coherence_length_m", area.window().coherenceLength());
        report.putAll(EvaluationReport.tree(evaluation.grid()));
        return report;
    }

    private Map<String, String> text(DiffractionSetup setup, Choices choices, String title, ResponseMethod by) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", title);
        text.put("Patch", setup.patch().source());
        text.put("Method", by.label());
        text.put("Options", Methods.describe(by.in(choices)));
        return text;
    }
}
