package sunbeam.app.measure.performance;

import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchRequest;

/** {@code sunbeam performance}: the report of speed against error, with plots. */
@Command(
        name = "performance",
        header = "Report speed against error, with plots.",
        description =
                "Measure the error and the time per pixel of every method on each patch; for method table what it takes to"
                        + " bake, how large it is and where that time goes, over the tolerance; how cost grows with the map's pixels, the"
                        + " patch's samples, its relief and the coherence length; and beside them the look-up of Dhillon et al. 2014."
                        + " Writes a page (Markdown), and a folder of the same name with plots (PNG) and tables (CSV). Takes up to an"
                        + " hour on two processors that do nothing else, most of it for the exact colours; --quick, a fraction of that.")
public final class PerformanceCommand implements Callable<Integer> {
    private static final List<String> DEFAULT_PATCHES = List.of("blaze", "elaphe-like", "xenopeltis-like");
    private static final String ENDING = ".md";

    private final Environment environment;
    private final Scale usual;
    private final String growing;

    @Option(
            names = "--patch",
            paramLabel = "PATCH",
            description = "A built-in patch or a descriptor (.json); may be given several times. Default: blaze,"
                    + " elaphe-like, xenopeltis-like.")
    private List<String> patches = new ArrayList<>();

    @Option(
            names = "--output",
            paramLabel = "PAGE.md",
            defaultValue = "performance.md",
            description = "The page to write. Default: ${DEFAULT-VALUE}.")
    private Path output;

    @Option(names = "--quick", description = "Fewer tolerances, points and views: a first impression.")
    private boolean quick;

    @Mixin
    private ForceOption force;

    @Spec
    private CommandSpec specification;

    public PerformanceCommand(Environment environment) {
        this(environment, Scale.USUAL, "elaphe-like");
    }

    /** @param growing the patch whose cost grows */
    PerformanceCommand(Environment environment, Scale usual, String growing) {
        this.environment = environment;
        this.usual = usual;
        this.growing = growing;
    }

    @Override
    public Integer call() {
        String name = String.valueOf(output.getFileName());
        if (!name.endsWith(ENDING) || name.length() == ENDING.length()) {
            throw new UsageException("--output " + output + " is no page; give it the ending .md");
        }
        Overwrite overwrite = force.overwrite();
        String folder = name.substring(0, name.length() - ENDING.length());
        AtomicFile.checkWritable(output, overwrite);
        Map<String, Patch> named = load();
        OutputFolder.create(output.resolveSibling(folder));
        Scale scale = quick ? Scale.QUICK : usual;
        double loadBefore = load1();
        try (RenderContext context = RenderContexts.offscreen();
                Progress progress = Progress.start("Performance", named.size() + 1L)) {
            Meter meter = new Meter(context, scale.mapSize(), scale.frames());
            PerformancePlots plots = new PerformancePlots(output.resolveSibling(folder), overwrite);
            List<PatchFigures> figures = new ArrayList<>();
            named.forEach((key, patch) -> {
                figures.add(new MethodsExperiment(
                                meter,
                                scale,
                                new DiffractionSetup(
                                        patch,
                                        environment,
                                        specification.commandLine().getErr()),
                                key)
                        .run());
                plots.write(figures.get(figures.size() - 1));
                progress.step(1);
            });
            Patch base = PatchOptions.load(PatchRequest.of(growing));
            List<Growth> growths = new GrowthExperiment(meter, scale, environment, base).run();
            growths.forEach(plots::write);
            progress.step(1);
            String machine = machine(context, loadBefore);
            String page = new PerformancePage(machine, scale, folder, figures, growths).text();
            AtomicFile.write(output, overwrite, stream -> stream.write(page.getBytes(StandardCharsets.UTF_8)));
        }
        specification.commandLine().getOut().println(output);
        return ExitCode.OK.code();
    }

    /** By names that differ, as files are named after them. */
    private Map<String, Patch> load() {
        Map<String, Patch> named = new LinkedHashMap<>();
        Set<String> taken = new HashSet<>();
        for (String given : patches.isEmpty() ? DEFAULT_PATCHES : patches) {
            Patch patch = PatchOptions.load(PatchRequest.of(given));
            String name = patch.name();
            for (int number = 2; !taken.add(name); number++) {
                name = patch.name() + "-" + number;
            }
            named.put(name, patch);
        }
        return named;
    }

    private static double load1() {
        return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    }

    private static String machine(RenderContext context, double loadBefore) {
        int processors = Runtime.getRuntime().availableProcessors();
        double after = load1();
        String load = loadBefore < 0 || after < 0
                ? "of unknown load"
                : String.format(
                        Locale.ROOT,
                        "with a load average of %.1f before the run and %.1f after it (above %d other work slows it down)",
                        loadBefore,
                        after,
                        processors);
        return String.format(
                Locale.ROOT, "%s, %d processors, %s", context.info().renderer(), processors, load);
    }
}
