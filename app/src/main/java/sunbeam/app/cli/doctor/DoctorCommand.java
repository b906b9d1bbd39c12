package sunbeam.app.cli.doctor;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import jrtr.GraphicsException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import sunbeam.app.cli.doctor.Machine.Check;
import sunbeam.app.cli.options.JsonOption;
import sunbeam.app.cli.options.ReportingCommand;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;

/** {@code sunbeam doctor}: says whether rendering works here, and what to do if it does not. */
@Command(
        name = "doctor",
        header = "Check whether rendering works on this machine.",
        description = "Tell whether rendering works on this machine: Java, memory, display, OpenGL, cache folder.%n"
                + "Each line begins with ok or FAIL; below a FAIL stands what to do.%n"
                + "The exit code says whether rendering works: 0 if it does, 5 if not.")
public final class DoctorCommand extends ReportingCommand {
    private final Environment environment;
    private final Supplier<List<Check>> graphics;

    @Mixin
    private JsonOption json;

    public DoctorCommand(Environment environment) {
        this(environment, Machine::graphics);
    }

    /** @param graphics opens an OpenGL context as rendering does and returns checks of it */
    DoctorCommand(Environment environment, Supplier<List<Check>> graphics) {
        this.environment = environment;
        this.graphics = graphics;
    }

    @Override
    public Integer call() {
        List<Check> checks = new ArrayList<>(Machine.examine(environment));
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
}
