package sunbeam.app.cli;

import com.sun.management.OperatingSystemMXBean;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import sunbeam.app.cli.options.JsonOption;
import sunbeam.app.cli.options.ReportingCommand;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.precompute.text.Text;

/** {@code sunbeam doctor}: says whether rendering works here, and what to do if it does not. */
@Command(
        name = "doctor",
        header = "Check whether rendering works on this machine.",
        description = "Tell whether rendering works on this machine: Java, memory, display, OpenGL, cache folder.%n"
                + "Each line begins with ok or FAIL; below a FAIL stands what to do.%n"
                + "The exit code says whether rendering works: 0 if it does, 5 if not.")
public final class DoctorCommand extends ReportingCommand {
    private static final double MEBIBYTE = 1024.0 * 1024.0;
    /** Least heap without a complaint: the largest patches in tests need less. */
    private static final double LEAST_HEAP_MEBIBYTES = 1024;

    private final Environment environment;
    private final Supplier<List<Check>> graphics;

    @Mixin
    private JsonOption json;

    public DoctorCommand(Environment environment) {
        this(environment, DoctorCommand::graphics);
    }

    DoctorCommand(Environment environment, Supplier<List<Check>> graphics) {
        this.environment = environment;
        this.graphics = graphics;
    }

    @Override
    public Integer call() {
        List<Check> checks = new ArrayList<>(examine(environment));
        List<Check> rendering = examineGraphics();
        checks.addAll(rendering);
        boolean renders = rendering.stream().allMatch(Check::isOk);
        if (json.isGiven()) {
            JsonOption.print(out(), report(renders, checks));
        } else {
            print(checks, out());
        }
        return renders ? ExitCode.OK.code() : ExitCode.NO_GRAPHICS.code();
    }

    private List<Check> examineGraphics() {
        try {
            return graphics.get();
        } catch (GraphicsException failure) {
            return List.of(Check.failed("Graphics", "not usable", failure.getMessage()));
        }
    }

    private static Map<String, Object> report(boolean renders, List<Check> checks) {
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("renders", renders);
        report.put("checks", checks.stream().map(DoctorCommand::report).toList());
        return report;
    }

    private static Map<String, Object> report(Check check) {
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("name", check.name());
        report.put("ok", check.isOk());
        report.put("value", check.value());
        check.remedy().ifPresent(remedy -> report.put("remedy", remedy));
        return report;
    }

    private static void print(List<Check> checks, PrintWriter out) {
        int width =
                checks.stream().mapToInt(check -> check.name().length()).max().orElse(0);
        for (Check check : checks) {
            String name = check.name() + " ".repeat(width - check.name().length());
            out.println((check.isOk() ? "ok    " : "FAIL  ") + name + "  " + check.value());
            check.remedy().ifPresent(remedy -> out.println(" ".repeat(6 + width + 2) + remedy));
        }
    }

    /** Line of the report: name of a property, its value, and a remedy if the value prevents or limits rendering. */
    record Check(String name, String value, Optional<String> remedy) {
        static Check ok(String name, String value) {
            return new Check(name, value, Optional.empty());
        }

        static Check failed(String name, String value, String remedy) {
            return new Check(name, value, Optional.of(remedy));
        }

        boolean isOk() {
            return remedy.isEmpty();
        }
    }

    static List<Check> examine(Environment environment) {
        List<Check> checks = new ArrayList<>();
        checks.add(Check.ok(
                "Java",
                System.getProperty("java.version") + ", " + System.getProperty("java.vendor") + ", "
                        + System.getProperty("java.home")));
        checks.add(Check.ok(
                "Operating system",
                System.getProperty("os.name") + " " + System.getProperty("os.version") + ", "
                        + System.getProperty("os.arch")));
        checks.add(Check.ok("Cores", Integer.toString(Runtime.getRuntime().availableProcessors())));
        checks.add(heap());
        checks.add(memory());
        checks.add(display(environment));
        checks.add(cache(CacheFolder.of(environment)));
        return checks;
    }

    static List<Check> graphics() {
        try (RenderContext context = RenderContext.offscreen()) {
            return describe(context.info());
        }
    }

    private static List<Check> describe(RenderContext.ContextInfo info) {
        RenderContext.ContextInfo.Limits limits = info.limits();
        return List.of(
                Check.ok("GL vendor", info.vendor()),
                Check.ok("GL renderer", info.renderer() + (info.software() ? ", in software" : "")),
                Check.ok("GL version", info.version() + ", GLSL " + info.shadingLanguageVersion()),
                Check.ok("Texture size", limits.textureSize() + " x " + limits.textureSize() + " texels"),
                Check.ok("Array layers", Integer.toString(limits.arrayLayers())),
                Check.ok("Picture size", limits.targetWidth() + " x " + limits.targetHeight() + " pixels"));
    }

    private static Check heap() {
        double mebibytes = Runtime.getRuntime().maxMemory() / MEBIBYTE;
        String value = size(mebibytes) + " at most";
        return mebibytes >= LEAST_HEAP_MEBIBYTES
                ? Check.ok("Heap", value)
                : Check.failed("Heap", value, "large patches need 1 GiB and more: set SUNBEAM_JAVA_OPTIONS=-Xmx2g");
    }

    private static Check memory() {
        if (ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system) {
            return Check.ok(
                    "Free memory",
                    size(system.getFreeMemorySize() / MEBIBYTE) + " of "
                            + size(system.getTotalMemorySize() / MEBIBYTE));
        }
        return Check.ok("Free memory", "not reported by this Java");
    }

    private static Check display(Environment environment) {
        String display = environment.variable("DISPLAY");
        boolean needed = System.getProperty("os.name").equals("Linux");
        if (!display.isEmpty()) {
            return Check.ok("Display", display);
        }
        return needed
                ? Check.failed("Display", "DISPLAY is not set", "start with ./sunbeam, which starts Xvfb")
                : Check.ok("Display", "the system's own");
    }

    private static Check cache(CacheFolder cache) {
        List<String> warnings = new ArrayList<>();
        String place = cache.path().toString();
        try {
            if (cache.open(warnings::add).isPresent()) {
                long bytes = cache.entries().stream()
                        .mapToLong(CacheFolder.Entry::bytes)
                        .sum();
                String used = ByteSize.format(bytes) + " used of "
                        + ByteSize.format(cache.limit()) + " allowed, "
                        + ByteSize.format(cache.path().toFile().getUsableSpace()) + " free on the disk";
                return Check.ok("Cache folder", place + ", " + used);
            }
            return Check.failed("Cache folder", place, warnings.get(0));
        } catch (UncheckedIOException failure) {
            return Check.failed("Cache folder", place, failure.getMessage() + "; make it readable or remove it");
        }
    }

    private static String size(double mebibytes) {
        return mebibytes < 1024 ? Text.format("%.0f MiB", mebibytes) : Text.format("%.1f GiB", mebibytes / 1024);
    }
}
