package sunbeam.app.cli;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.INTERPOLATION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.Meter.Measurement;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.spectrum.PeriodInterpolation;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/** {@code sunbeam benchmark}: error of the methods, and their time as a ratio to that of the thesis's shader in the same run. */
@Command(
        name = "benchmark",
        header = "Measure error and time of the methods.",
        description = "Measure each method's error of X, Y, Z against the exact reference and its time per pixel of a"
                + " BRDF map, relative to the thesis's shader (full --preset thesis) in the same run, since an"
                + " absolute time on a shared machine means nothing; and the time and memory that its tables need."
                + " With --method, or an option that belongs to one, that method alone. Prints tables (Markdown); with"
                + " --output writes them as a page, with plots and all numbers beside it.",
        footer = {"  sunbeam benchmark --output speed.md", "  sunbeam benchmark --patch scan.gwy --method table"})
public final class BenchmarkCommand extends FileCommand {
    private static final List<String> PATCHES = List.of("blaze", "elaphe-like");
    private static final int MOST_VIEWS = 10_000;
    static final String THESIS = "full, thesis";

    private static final Map<MethodType, List<Double>> TOLERANCES =
            Map.of(FullMethod.TYPE, List.of(1e-2, 1e-3, 1e-4), TableMethod.TYPE, List.of(1e-2, 1e-3));

    @Option(
            names = "--patch",
            paramLabel = "PATCH",
            description = "A built-in patch, a descriptor (.json) or a scan; may be repeated. Default: blaze and"
                    + " elaphe-like.")
    private List<String> names = new ArrayList<>();

    @Mixin
    private final PatchOptions patchOptions = PatchOptions.withoutPatch();

    @Mixin
    private LightOptions light;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private PageOptions page;

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "256",
            description = "Width and height of the map, 16 to 2048. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Option(
            names = "--samples",
            paramLabel = "N",
            defaultValue = "16",
            description =
                    "Views at which errors are measured, 0 (not at all) to " + MOST_VIEWS + ": one takes seconds on a"
                            + " scan, and some ten times as long with --average ensemble. Default: ${DEFAULT-VALUE}.")
    private int samples;

    @Option(
            names = "--complexity",
            description = "Measure instead how the time of the thesis's methods grows with wavelengths, terms and bins,"
                    + " and with samples and periods of the patch (thesis, section 3.5). Default patch: blaze.")
    private boolean complexity;

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description =
                    "A page to write; plots (PNG) and numbers (CSV) go into a folder of the same name. Or a picture"
                            + " (.pdf, .svg, .png) of the plots, with the numbers beside it (.csv).")
    private Path output;

    @Override
    public Integer call() {
        Choices choices = methodOptions.choices();
        return choices.located(() -> measure(choices));
    }

    private int measure(Choices asked) {
        Methods.of(asked);
        UsageException.requireWithin("--size", size, 16, 2048);
        UsageException.requireWithin("--samples", samples, 0, MOST_VIEWS);
        if (output != null) {
            page.width();
            BenchmarkPage.checkWritable(output, overwrite());
        }
        UsageException.throwIf(
                complexity && !isMethodOpen(asked),
                "--complexity measures the thesis's methods; leave out --method and the settings of methods");
        // All patches are read and checked first: measuring one takes minutes.
        List<String> standard = complexity ? PATCHES.subList(0, 1) : PATCHES;
        List<Patch> patches = patchOptions.load(names.isEmpty() ? standard : names, asked);
        if (output != null) {
            BenchmarkPage.requireRoom(output, patches.size(), page);
        }
        try (RenderContext context = RenderContext.offscreen()) {
            Meter meter = new Meter(context, size, light.direction());
            BenchmarkPage results = new BenchmarkPage(context.info().renderer(), light.describe(), size, samples);
            print(results.introduction());
            for (Patch patch : patches) {
                print(complexity ? growth(meter, results, patch) : methods(meter, results, patch, asked));
            }
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("renderer", context.info().renderer());
            report.put("size", size);
            report.put("measured", results.numbers());
            json.print(out(), report, output == null ? List.of() : results.write(output, overwrite(), page));
        }
        return ExitCode.OK.code();
    }

    private void print(String words) {
        json.text(out()).print(words);
        out().flush();
    }

    /** Measures the thesis's shader, then the requested methods. If none is chosen, a failure of one becomes a remark. */
    private String methods(Meter meter, BenchmarkPage results, Patch patch, Choices asked) {
        DiffractionSetup setup = setup(patch);
        List<String> remarks = new ArrayList<>();
        Map<String, Method> contenders = contenders(setup.limitToScan(asked, err()));
        Optional<Meter.ExactViews> views =
                samples == 0 ? Optional.empty() : Optional.of(new Meter.ExactViews(setup, meter.light(), samples));
        List<Measurement> rows = new ArrayList<>();
        try (Progress progress = environment().progress().start("Benchmark " + patch.name(), contenders.size())) {
            contenders.forEach((name, method) -> {
                try {
                    rows.add(meter.measure(setup, name, method, views));
                } catch (GraphicsException | SettingException unmeasured) {
                    if (!isMethodOpen(asked) || rows.isEmpty()) {
                        throw unmeasured;
                    }
                    remarks.add(name + " is not measured: " + unmeasured.getMessage());
                }
                progress.step(1);
            });
        }
        return results.addMethods(rows, remarks, page.pixels());
    }

    private String growth(Meter meter, BenchmarkPage results, Patch patch) {
        CostGrowth growth = new CostGrowth(setup(patch), environment());
        List<CostGrowth.Variant> variants = growth.variants();
        try (Progress progress = environment().progress().start("Benchmark " + patch.name(), variants.size())) {
            List<Measurement> rows = new ArrayList<>();
            rows.add(meter.measure(growth.setup(), THESIS, FullMethod.thesis(), Optional.empty()));
            for (CostGrowth.Variant variant : variants) {
                rows.add(CostGrowth.measure(meter, variant));
                progress.step(1);
            }
            return results.addGrowth(rows, CostGrowth.plot(variants, rows, page.pixels()));
        }
    }

    private DiffractionSetup setup(Patch patch) {
        return new DiffractionSetup(patch, environment(), err()).withLight(LightTable.of(methodOptions.choices()));
    }

    /** True if the user has chosen neither a method nor a setting that only some methods have. */
    private static boolean isMethodOpen(Choices choices) {
        List<Setting<?>> common = Setting.union(List.of(TOLERANCE), GaussianArea.SETTINGS, MethodSettings.LIGHT);
        return choices.only(Methods.SETTINGS).without(common).chosen().isEmpty();
    }

    /**
     * Returns, by name, the thesis's shader and the chosen method or, if none is chosen, all but the reference: {@code full} and {@code table}
     * at several tolerances, {@code nmm} and {@code pq} with the thesis's choices, too.
     */
    private static Map<String, Method> contenders(Choices choices) {
        Map<String, Method> all = new LinkedHashMap<>(Map.of(THESIS, FullMethod.thesis()));
        if (!isMethodOpen(choices)) {
            all.put(name(choices, Methods.of(choices).type()), Methods.of(choices));
            return all;
        }
        for (MethodType type : Methods.ALL) {
            if (!type.equals(ReferenceMethod.TYPE)) {
                variants(type, choices).forEach(one -> all.put(name(one, type), type.create(one)));
            }
        }
        return all;
    }

    private static List<Choices> variants(MethodType type, Choices choices) {
        List<Double> tolerances = choices.has(TOLERANCE) ? List.of() : TOLERANCES.getOrDefault(type, List.of());
        List<Choices> variants = new ArrayList<>();
        tolerances.forEach(tolerance -> variants.add(choices.with(TOLERANCE, tolerance)));
        if (variants.isEmpty()) {
            variants.add(choices);
        }
        if (type.has(INTERPOLATION)) {
            variants.add(choices.with(INTERPOLATION, PeriodInterpolation.LINEAR));
        }
        if (type.equals(NmmMethod.TYPE) || type.equals(PqMethod.TYPE)) {
            variants.add(choices.without(TOLERANCE).with(PRESET, Preset.THESIS));
        }
        return variants;
    }

    private static String name(Choices choices, MethodType type) {
        StringBuilder name = new StringBuilder(type.label());
        if (Preset.isThesis(choices)) {
            name.append(", preset thesis");
        } else if (type.has(TOLERANCE)) {
            String tolerance = Text.format("%.1e", choices.get(TOLERANCE));
            name.append(", tolerance ").append(tolerance.replace(".0e", "e").replace("e-0", "e-"));
        }
        if (type.has(INTERPOLATION) && choices.has(INTERPOLATION)) {
            name.append(", ").append(choices.written(INTERPOLATION));
        }
        if (type.has(AVERAGE) && choices.get(AVERAGE) == Average.ENSEMBLE) {
            name.append(", ensemble");
        }
        return name.toString();
    }
}
