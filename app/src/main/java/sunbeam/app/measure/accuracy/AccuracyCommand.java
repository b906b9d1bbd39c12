package sunbeam.app.measure.accuracy;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.measure.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.JsonOption;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.units.Lengths;

/** {@code sunbeam accuracy}: measures and plots how the error depends on each choice of method full, and on the method. */
@Command(
        name = "accuracy",
        header = "Measure and plot errors, and errors over time.",
        description = "Measure and plot the error of method full against the exact reference: over the number of terms"
                + " of each expansion, the neighbourhood, the wavelength step, and the tolerance, on random directions,"
                + " half of them aimed at diffraction orders; and of all methods over their time per pixel. Writes"
                + " tables (CSV), plots (PNG) and a page that shows them (README.md) into a folder. Takes some minutes"
                + " a patch; --quick, one. Exact values are kept in the folder (exact-values.txt): a run that was stopped goes"
                + " on with them, given --force. With --cases, holds method full to its tolerance on given surfaces and"
                + " directions instead: prints a line for each; exit code 3 when one is missed.")
public final class AccuracyCommand implements Callable<Integer> {
    private static final List<String> DEFAULT_PATCHES = List.of("blaze", "elaphe-like", "xenopeltis-like");
    private static final List<Double> CASE_TOLERANCES = List.of(1e-2, 1e-3, 1e-4);
    private static final String JOURNAL = "exact-values.txt";
    private static final long FIRST_SEED = 1;
    private static final SampleCounts USUAL = new SampleCounts(300, 100, 3);
    private static final SampleCounts QUICK = new SampleCounts(120, 10, 3);
    private static final int USUAL_MAP = 128;
    private static final int QUICK_MAP = 128;

    private final Environment environment;

    @Option(
            names = "--patch",
            paramLabel = "PATCH",
            description = "A built-in patch or a descriptor (.json); may be given several times. Default: blaze,"
                    + " elaphe-like, xenopeltis-like.")
    private List<String> patches = new ArrayList<>();

    @Option(
            names = "--output",
            paramLabel = "FOLDER",
            defaultValue = "accuracy",
            description = "Where the files go; made if it is missing. Default: ${DEFAULT-VALUE}.")
    private Path output;

    @Option(
            names = "--cases",
            paramLabel = "FOLDER",
            description =
                    "A folder of cases with exact values: index.csv names case, patch and options, CASE/in.csv has"
                            + " directions and exact_power, exact_power_ensemble or exact_X,exact_Y,exact_Z"
                            + " (docs/accuracy). Nothing is written.")
    private Path cases;

    @Option(
            names = "--tolerance",
            paramLabel = "ERROR",
            split = ",",
            description = "With --cases: the tolerances that are tried. Default: 1e-2,1e-3,1e-4.")
    private List<Double> tolerances = new ArrayList<>();

    @Option(
            names = "--random",
            paramLabel = "N",
            description =
                    "Draw N surfaces with window, average, tolerance and directions, and compare with the reference"
                            + " instead: prints those that miss, and the distribution by kind.")
    private Integer random;

    @Option(
            names = "--seed",
            paramLabel = "SEED",
            description = "With --random: the first case's; the next ones count up. Default: " + FIRST_SEED + ".")
    private Long seed;

    @Option(
            names = "--keep",
            paramLabel = "FOLDER",
            description = "With --random: also write the cases that have light into a folder, as --cases reads them.")
    private Path keep;

    @Option(
            names = "--extremes",
            description =
                    "Hold method full to its tolerance on surfaces at the edges of what can be asked for instead (mirror,"
                            + " dust, one to 4096 samples, relief to 5 um, sides to 5 mm, windows of 1 um to 1 mm):"
                            + " prints a table, median / 95th percentile for three tolerances.")
    private boolean extremes;

    @Option(names = "--quick", description = "Fewer directions: a first impression in a fifth of the time.")
    private boolean quick;

    @Mixin
    private ForceOption force;

    @Mixin
    private JsonOption json;

    @Spec
    private CommandSpec specification;

    public AccuracyCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        requireOneTask();
        if (cases != null) {
            return holdToCases().code();
        }
        if (random != null) {
            return drawCases().code();
        }
        if (extremes) {
            return goToExtremes().code();
        }
        SampleCounts counts = quick ? QUICK : USUAL;
        Map<String, String> descriptions = new LinkedHashMap<>();
        Map<String, Patch> named = load(descriptions);
        AccuracyReport report = new AccuracyReport(output, force.overwrite(), descriptions);
        makeFolder();
        report.checkWritable();
        List<Experiment> experiments = Experiments.all();
        ExactJournal journal = ExactJournal.of(output.resolve(JOURNAL));
        int costEach = Subject.cost(counts)
                + experiments.stream().mapToInt(Experiment::cost).sum();
        try (RenderContext context = RenderContexts.offscreen();
                Progress progress = Progress.start("Accuracy", (long) costEach * named.size())) {
            named.forEach((name, patch) -> {
                PrintWriter err = specification.commandLine().getErr();
                DiffractionSetup setup = new DiffractionSetup(patch, environment, err);
                Subject subject = new Subject(
                        name, context, setup, counts, journal, quick ? QUICK_MAP : USUAL_MAP, progress::step);
                for (Experiment experiment : experiments) {
                    report.add(name, experiment.run(subject));
                    progress.step(experiment.cost());
                }
                // What is done by now, lest hours be lost.
                report.write(counts, context.info().renderer());
            });
        }
        specification.commandLine().getOut().println(report.file());
        return ExitCode.OK.code();
    }

    /** Refuses, before hours are spent on something else, what the task asked for would not heed. */
    private void requireOneTask() {
        List<String> tasks = new ArrayList<>();
        if (cases != null) {
            tasks.add("--cases");
        }
        if (random != null) {
            tasks.add("--random");
        }
        if (extremes) {
            tasks.add("--extremes");
        }
        if (tasks.size() > 1) {
            throw new UsageException(String.join(" and ", tasks) + " are several tasks; leave all but one of them out");
        }
        if (!tasks.isEmpty() && (!patches.isEmpty() || quick)) {
            throw new UsageException("--patch and --quick are not for " + tasks.get(0)
                    + ", which has surfaces of its own; leave them out");
        }
        if (cases == null && !tolerances.isEmpty()) {
            throw new UsageException("--tolerance belongs to --cases; leave it out");
        }
        if (cases == null && json.isAsked()) {
            throw new UsageException("--json belongs to --cases; leave it out: the tables of a run are CSV files");
        }
        if (random == null && seed != null) {
            throw new UsageException("--seed " + seed + " belongs to --random; leave it out, or add --random");
        }
        if (random == null && keep != null) {
            throw new UsageException("--keep " + keep + " belongs to --random; leave it out, or add --random");
        }
        if (random != null && random < 1) {
            throw new UsageException("--random " + random + " is out of range; give 1 or more");
        }
    }

    private ExitCode drawCases() {
        Optional<KeptCases> kept = Optional.ofNullable(keep).map(folder -> new KeptCases(folder, force.overwrite()));
        try (RenderContext context = RenderContexts.offscreen()) {
            int missed = new RandomCases(context, specification.commandLine().getOut(), kept)
                    .run(seed == null ? FIRST_SEED : seed, random);
            return missed == 0 ? ExitCode.OK : ExitCode.TOLERANCE_MISSED;
        }
    }

    private ExitCode goToExtremes() {
        try (RenderContext context = RenderContexts.offscreen()) {
            int missed = new Extremes(context, specification.commandLine().getOut()).run(Extreme.all());
            return missed == 0 ? ExitCode.OK : ExitCode.TOLERANCE_MISSED;
        }
    }

    private ExitCode holdToCases() {
        List<AccuracyCase> all = AccuracyCase.readAll(cases);
        PrintWriter out = specification.commandLine().getOut();
        PrintWriter err = specification.commandLine().getErr();
        List<CaseRunner.Outcome> outcomes = new ArrayList<>();
        try (RenderContext context = RenderContexts.offscreen()) {
            CaseRunner runner = new CaseRunner(context);
            for (AccuracyCase surface : all) {
                DiffractionSetup setup = new DiffractionSetup(surface.patch(), environment, err);
                for (double tolerance : tolerances.isEmpty() ? CASE_TOLERANCES : tolerances) {
                    for (CaseRunner.Outcome outcome : runner.run(surface, setup, tolerance)) {
                        if (!json.isAsked()) {
                            out.println(outcome.line());
                            out.flush();
                        }
                        outcomes.add(outcome);
                    }
                }
            }
        }
        long kept = outcomes.stream()
                .filter(outcome -> outcome.verdict() == CaseRunner.Verdict.KEPT)
                .count();
        if (json.isAsked()) {
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("tried", outcomes.size());
            report.put("kept", kept);
            report.put(
                    "cases", outcomes.stream().map(CaseRunner.Outcome::fields).toList());
            JsonOption.print(out, report);
        } else {
            out.println(kept + " of " + outcomes.size() + " kept");
        }
        return kept == outcomes.size() ? ExitCode.OK : ExitCode.TOLERANCE_MISSED;
    }

    /** By names that differ, as files are named after them. */
    private Map<String, Patch> load(Map<String, String> descriptions) {
        Map<String, Patch> named = new LinkedHashMap<>();
        Set<String> taken = new HashSet<>();
        for (String given : patches.isEmpty() ? DEFAULT_PATCHES : patches) {
            Patch patch = PatchOptions.load(PatchRequest.of(given));
            String name = patch.name();
            for (int number = 2; !taken.add(name); number++) {
                name = patch.name() + "-" + number;
            }
            named.put(name, patch);
            descriptions.put(name, describe(given, patch.heights()));
        }
        return named;
    }

    /** Without the folder, which is nobody else's. */
    private static String describe(String given, HeightMap map) {
        String origin = BuiltInPatches.names().contains(given)
                ? "built-in"
                : Path.of(given).getFileName().toString();
        return String.format(
                Locale.ROOT,
                "%s, %d x %d samples, %s x %s",
                origin,
                map.columns(),
                map.rows(),
                Lengths.format(map.width()),
                Lengths.format(map.height()));
    }

    private void makeFolder() {
        try {
            Files.createDirectories(output);
        } catch (IOException failure) {
            throw new OutputException(
                    "cannot make the folder " + output + ": " + failure.getMessage() + "; choose another", failure);
        }
    }
}
