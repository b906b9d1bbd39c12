package sunbeam.app.measure.benchmark;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** {@code sunbeam benchmark}: time per frame of a BRDF map, as a ratio to the thesis's shader in the same run. */
@Command(
        name = "benchmark",
        header = "Time a BRDF map against the thesis's shader.",
        description =
                "Time the drawing of a BRDF map and give it as a ratio to the thesis's shader (full --preset thesis),"
                        + " timed in the same run: an absolute time on a shared machine means nothing. The median of some frames"
                        + " after one for warming up.")
public final class BenchmarkCommand implements Callable<Integer> {
    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private LightOptions light;

    @Mixin
    private MethodOptions methodOptions;

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "256",
            description = "Width and height of the map. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Option(
            names = "--frames",
            paramLabel = "N",
            defaultValue = "3",
            description = "Frames that are timed, 1 to 100. Default: ${DEFAULT-VALUE}.")
    private int frames;

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
        if (size < 16 || size > 2048) {
            throw new UsageException("--size " + size + " is out of range; give 16 to 2048");
        }
        if (frames < 1 || frames > 100) {
            throw new UsageException("--frames " + frames + " is out of range; give 1 to 100");
        }
        Direction wi = light.direction();
        DiffractionSetup setup = new DiffractionSetup(
                patchOptions, asked, environment, specification.commandLine().getErr());
        Choices choices = setup.seen(asked, specification.commandLine().getErr());
        Method method = Methods.of(choices);
        GaussianArea area = GaussianArea.of(choices);
        VisibleRange range = VisibleRange.of(wi);
        List<Contender> contenders = List.of(
                new Contender("thesis", FullMethod.thesis().plan(setup.surface(), range)),
                new Contender("asked for", method.plan(setup.surface(), range)));
        List<FrameTime> times = new ArrayList<>();
        String renderer;
        try (RenderContext context = RenderContexts.offscreen()) {
            for (Contender contender : contenders) {
                times.add(time(context, setup, contender, wi));
            }
            renderer = context.info().renderer();
        }
        PrintWriter out = specification.commandLine().getOut();
        if (!json.isAsked()) {
            report(out, renderer, setup, times);
        }
        double rate =
                ReferenceRate.measure(new ReferenceEvaluator(setup.patch().heights(), area.window(), area.origin()));
        if (json.isAsked()) {
            JsonOption.print(out, fields(renderer, setup, times, rate));
        } else {
            out.printf(Locale.ROOT, "%n  reference: %.0f directions x wavelengths per second%n", rate);
        }
        return ExitCode.OK.code();
    }

    private Map<String, Object> fields(String renderer, DiffractionSetup setup, List<FrameTime> times, double rate) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("patch", setup.patch().name());
        fields.put("size", size);
        fields.put("coveredPixels", times.get(0).coveredPixels());
        fields.put("light", light.describe());
        fields.put("renderer", renderer);
        fields.put("processors", Runtime.getRuntime().availableProcessors());
        fields.put("clock", times.get(0).clock());
        fields.put("frames", frames);
        double thesisSeconds = times.get(0).frameSeconds();
        fields.put(
                "plans", times.stream().map(time -> time.fields(thesisSeconds)).toList());
        fields.put("referenceDirectionsTimesWavelengthsPerSecond", rate);
        return fields;
    }

    private FrameTime time(RenderContext context, DiffractionSetup setup, Contender contender, Direction wi) {
        long start = System.nanoTime();
        ShaderTables tables = setup.freshTables(contender.method(), MethodUse.COLOUR, GpuColours::of);
        long tableReady = System.nanoTime();
        try (UploadedTables method = UploadedTables.upload(context, tables)) {
            double uploadSeconds = (System.nanoTime() - tableReady) * 1e-9;
            FrameTimer.Timing timing = new FrameTimer(context, size, frames).time(method, wi);
            return new FrameTime(
                    contender,
                    (tableReady - start) * 1e-9,
                    uploadSeconds + timing.setupSeconds(),
                    timing.seconds(),
                    timing.coveredPixels(),
                    timing.clock());
        }
    }

    private void report(PrintWriter out, String renderer, DiffractionSetup setup, List<FrameTime> times) {
        FrameTime thesis = times.get(0);
        out.printf(
                Locale.ROOT,
                "BRDF map of %s, %d x %d, %d covered pixels, light at %s%n%s, %d processors, %s, median of %d frames%n%n",
                setup.patch().name(),
                size,
                size,
                thesis.coveredPixels(),
                light.describe(),
                renderer,
                Runtime.getRuntime().availableProcessors(),
                thesis.clock(),
                frames);
        out.println("  plan        tables  upload     frame  per pixel  times faster");
        for (FrameTime time : times) {
            out.printf(
                    Locale.ROOT,
                    "  %-10s %6.2f s %5.2f s %7.3f s %7.2f us %9.1f     %s%n",
                    time.contender().label(),
                    time.tableSeconds(),
                    time.uploadSeconds(),
                    time.frameSeconds(),
                    time.microsecondsPerPixel(),
                    thesis.frameSeconds() / time.frameSeconds(),
                    time.contender().description());
        }
    }
}
