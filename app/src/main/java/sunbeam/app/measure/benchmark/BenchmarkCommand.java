package sunbeam.app.measure.benchmark;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
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
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.JsonOption;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.LightOptions;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** {@code sunbeam benchmark}: time and error of BRDF maps, as a ratio to the thesis's shader in the same run. */
@Command(
        name = "benchmark",
        header = "Time a BRDF map against the thesis's shader.",
        description =
                "Time the drawing of a BRDF map and give it as a ratio to the thesis's shader (full --preset thesis),"
                        + " timed in the same run: an absolute time on a shared machine means nothing. The median of some frames"
                        + " after one for warming up. Without --average, both averages. Beside each time stand the error of"
                        + " X, Y, Z against the exact reference, on random views of the same light, half of them aimed at"
                        + " orders, and what it takes to make the tables (of method table: to bake the colours).")
public final class BenchmarkCommand implements Callable<Integer> {
    private static final int MOST_SAMPLES = 10_000;
    private static final int MOST_PATCHES = 24;

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Option(
            names = "--with",
            paramLabel = "PATCH",
            description = "Another surface to measure in the same run, with the same options; may be repeated.")
    private List<String> others = new ArrayList<>();

    @Mixin
    private LightOptions light;

    @Mixin
    private final MethodOptions methodOptions =
            MethodOptions.choosingAverage("both, one after the other, unless a preset is given");

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "256",
            description = "Width and height of the map, 16 to 2048. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Option(
            names = "--frames",
            paramLabel = "N",
            defaultValue = "3",
            description = "Frames that are timed, 1 to 100; of short ones as many as take half a second together."
                    + " Default: ${DEFAULT-VALUE}.")
    private int frames;

    @Option(
            names = "--samples",
            paramLabel = "N",
            defaultValue = "40",
            description = "Views at which the error is measured, 0 (not at all) to " + MOST_SAMPLES
                    + ". Default: ${DEFAULT-VALUE}.")
    private int samples;

    @Option(
            names = "--seed",
            paramLabel = "SEED",
            defaultValue = "3",
            description = "The same seed gives the same views. Default: ${DEFAULT-VALUE}.")
    private long seed;

    @Mixin
    private JsonOption json;

    @Spec
    private CommandSpec specification;

    public BenchmarkCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        Choices choices = methodOptions.choices();
        return choices.located(() -> measure(choices));
    }

    private int measure(Choices asked) {
        Methods.of(asked);
        requireWithin("--size", size, 16, 2048);
        requireWithin("--frames", frames, 1, 100);
        requireWithin("--samples", samples, 0, MOST_SAMPLES);
        Direction wi = light.direction();
        if (others.size() > MOST_PATCHES) {
            throw new UsageException(
                    "--with is given " + others.size() + " times; give it " + MOST_PATCHES + " at most");
        }
        // All are read, and what is wrong with one is told, before minutes are spent on the first.
        List<Patch> patches = new ArrayList<>(List.of(patchOptions.load(asked)));
        others.forEach(name -> patches.add(patchOptions.load(name, asked)));
        PrintWriter out = specification.commandLine().getOut();
        List<Map<String, Object>> surfaces = new ArrayList<>();
        try (RenderContext context = RenderContexts.offscreen()) {
            for (Patch patch : patches) {
                DiffractionSetup setup = new DiffractionSetup(
                        patch, environment, specification.commandLine().getErr());
                surfaces.add(measure(context, setup, asked, wi, out));
                out.flush();
            }
        }
        if (json.isAsked()) {
            JsonOption.print(out, Map.of("surfaces", surfaces));
        }
        return ExitCode.OK.code();
    }

    private static void requireWithin(String option, int value, int least, int most) {
        if (value < least || value > most) {
            throw new UsageException(
                    option + " " + value + String.format(Locale.ROOT, " is out of range; give %d to %d", least, most));
        }
    }

    /** Prints the report for people, unless that for programs is asked for; returns the latter. */
    private Map<String, Object> measure(
            RenderContext context, DiffractionSetup setup, Choices asked, Direction wi, PrintWriter out) {
        Choices choices = setup.seen(asked, specification.commandLine().getErr());
        MapSamples exact = new MapSamples(setup, wi, samples, seed);
        List<FrameTime> times = new ArrayList<>();
        for (Contender contender : contenders(setup, choices, wi)) {
            times.add(time(context, setup, contender, wi, exact));
        }
        String renderer = context.info().renderer();
        BenchmarkReport report =
                new BenchmarkReport(setup.patch().name(), size, frames, light.describe(), samples, seed);
        if (!json.isAsked()) {
            report.print(out, renderer, times);
        }
        GaussianArea area = GaussianArea.of(choices);
        double rate =
                ReferenceRate.measure(new ReferenceEvaluator(setup.patch().heights(), area.window(), area.origin()));
        if (!json.isAsked()) {
            out.printf(Locale.ROOT, "%n  reference: %.0f directions x wavelengths per second%n%n", rate);
        }
        return report.fields(renderer, times, rate);
    }

    /** The thesis's shader, then the method, with both averages where it has them and none was chosen. */
    private static List<Contender> contenders(DiffractionSetup setup, Choices choices, Direction wi) {
        VisibleRange range = VisibleRange.of(wi);
        Method thesis = FullMethod.thesis();
        List<Contender> all = new ArrayList<>(List.of(new Contender(
                "full, thesis", Optional.of(word(Average.COHERENT)), thesis, thesis.plan(setup.surface(), range))));
        for (Choices each : averages(choices)) {
            Method method = Methods.of(each);
            Optional<String> average =
                    method.type().has(AVERAGE) ? Optional.of(word(each.get(AVERAGE))) : Optional.empty();
            all.add(new Contender(method.type().label(), average, method, method.plan(setup.surface(), range)));
        }
        return all;
    }

    private static String word(Average average) {
        return average.name().toLowerCase(Locale.ROOT);
    }

    private static List<Choices> averages(Choices choices) {
        boolean both = choices.get(Methods.METHOD).has(AVERAGE)
                && !choices.has(AVERAGE)
                && choices.get(PRESET, Preset.NONE) == Preset.NONE;
        return both
                ? List.of(choices.with(AVERAGE, Average.COHERENT), choices.with(AVERAGE, Average.ENSEMBLE))
                : List.of(choices);
    }

    private FrameTime time(
            RenderContext context, DiffractionSetup setup, Contender contender, Direction wi, MapSamples exact) {
        long start = System.nanoTime();
        ShaderTables tables = setup.freshTables(contender.plan(), MethodUse.COLOUR, GpuColours::of);
        long tableReady = System.nanoTime();
        try (UploadedTables drawn = UploadedTables.upload(context, tables)) {
            double uploadSeconds = (System.nanoTime() - tableReady) * 1e-9;
            FrameTimer.Timing timing = new FrameTimer(context, size, frames).time(drawn, wi);
            boolean comparable = samples > 0 && contender.method().brightness() == Method.Brightness.OF_A_MIRROR;
            return new FrameTime(
                    contender,
                    (tableReady - start) * 1e-9,
                    uploadSeconds + timing.setupSeconds(),
                    timing.seconds(),
                    timing.coveredPixels(),
                    timing.clock(),
                    comparable ? Optional.of(exact.errors(context, contender.method(), drawn)) : Optional.empty());
        }
    }
}
