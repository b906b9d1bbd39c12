package sunbeam.app.cli;

import com.sun.management.OperatingSystemMXBean;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
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
    private static final String GRAPHICS = "Graphics";
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
        try {
            checks.addAll(graphics.get());
        } catch (GraphicsException failure) {
            checks.add(Check.failed(GRAPHICS, "not usable", failure.getMessage()));
        }
        boolean renders = checks.stream().noneMatch(check -> check.name.equals(GRAPHICS));
        if (json.isGiven()) {
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("renders", renders);
            report.put("checks", checks.stream().map(Check::report).toList());
            json.print(out(), report, List.of());
        } else {
            checks.forEach(check -> out().println(check.text()));
        }
        return renders ? ExitCode.OK.code() : ExitCode.NO_GRAPHICS.code();
    }

    /** Line of the report: name of a property, its value, and a remedy if the value prevents or limits rendering. */
    record Check(String name, String value, Optional<String> remedy) {
        static Check ok(String name, String value) {
            return new Check(name, value, Optional.empty());
        }

        static Check failed(String name, String value, String remedy) {
            return new Check(name, value, Optional.of(remedy));
        }

        private Map<String, Object> report() {
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("name", name);
            report.put("ok", remedy.isEmpty());
            report.put("value", value);
            remedy.ifPresent(words -> report.put("remedy", words));
            return report;
        }

        private String text() {
            // The second column fits the longest name, that of the operating system.
            return Text.format("%-4s  %-16s  %s", remedy.isEmpty() ? "ok" : "FAIL", name, value)
                    + remedy.map(words -> System.lineSeparator() + " ".repeat(24) + words)
                            .orElse("");
        }
    }

    private static List<Check> examine(Environment environment) {
        return List.of(
                Check.ok("Java", properties(", ", "java.version", "java.vendor", "java.home")),
                Check.ok(
                        "Operating system",
                        properties(" ", "os.name", "os.version") + ", " + properties("", "os.arch")),
                Check.ok("Cores", Integer.toString(Runtime.getRuntime().availableProcessors())),
                heap(),
                memory(),
                display(environment),
                cache(CacheFolder.of(environment)));
    }

    private static String properties(String between, String... names) {
        return Arrays.stream(names).map(System::getProperty).collect(Collectors.joining(between));
    }

    private static List<Check> graphics() {
        try (RenderContext context = RenderContext.offscreen()) {
            RenderContext.ContextInfo info = context.info();
            RenderContext.ContextInfo.Limits limits = info.limits();
            return List.of(
                    Check.ok("GL vendor", info.vendor()),
                    Check.ok("GL renderer", info.renderer() + (info.software() ? ", in software" : "")),
                    Check.ok("GL version", info.version() + ", GLSL " + info.shadingLanguageVersion()),
                    Check.ok("Texture size", limits.textureSize() + " x " + limits.textureSize() + " texels"),
                    Check.ok("Array layers", Integer.toString(limits.arrayLayers())),
                    Check.ok("Picture size", limits.targetWidth() + " x " + limits.targetHeight() + " pixels"));
        }
    }

    private static Check heap() {
        double mebibytes = Runtime.getRuntime().maxMemory() / MEBIBYTE;
        String value = size(mebibytes) + " at most";
        return mebibytes >= LEAST_HEAP_MEBIBYTES
                ? Check.ok("Heap", value)
                : Check.failed("Heap", value, "large patches need 1 GiB and more: set SUNBEAM_JAVA_OPTIONS=-Xmx2g");
    }

    private static Check memory() {
        String sizes = ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
                ? size(system.getFreeMemorySize() / MEBIBYTE) + " of " + size(system.getTotalMemorySize() / MEBIBYTE)
                : "not reported by this Java";
        return Check.ok("Free memory", sizes);
    }

    private static Check display(Environment environment) {
        String display = environment.variable("DISPLAY");
        return display.isEmpty() && System.getProperty("os.name").equals("Linux")
                ? Check.failed("Display", "DISPLAY is not set", "start with ./sunbeam, which starts Xvfb")
                : Check.ok("Display", display.isEmpty() ? "the system's own" : display);
    }

    private static Check cache(CacheFolder cache) {
        List<String> warnings = new ArrayList<>();
        String place = cache.path().toString();
        try {
            if (cache.open(warnings::add).isEmpty()) {
                return Check.failed("Cache folder", place, warnings.get(0));
            }
            long used =
                    cache.entries().stream().mapToLong(CacheFolder.Entry::bytes).sum();
            String sizes = Text.format(
                    "%s, %s used of %s allowed, %s free on the disk",
                    place,
                    ByteSize.format(used),
                    ByteSize.format(cache.limit()),
                    ByteSize.format(cache.path().toFile().getUsableSpace()));
            return Check.ok("Cache folder", sizes);
        } catch (UncheckedIOException failure) {
            return Check.failed("Cache folder", place, failure.getMessage() + "; make it readable or remove it");
        }
    }

    private static String size(double mebibytes) {
        return mebibytes < 1024 ? Text.format("%.0f MiB", mebibytes) : Text.format("%.1f GiB", mebibytes / 1024);
    }
}
