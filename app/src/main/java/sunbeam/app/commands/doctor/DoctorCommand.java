package sunbeam.app.commands.doctor;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import jrtr.GraphicsException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;

/** {@code sunbeam doctor}: says whether rendering works here, and what to do where it does not. */
@Command(
        name = "doctor",
        header = "Check whether rendering works on this machine.",
        description = "Tell whether rendering works on this machine: Java, memory, display, OpenGL, cache folder.%n"
                + "Each line begins with ok or FAIL; below a FAIL stands what to do.%n"
                + "The exit code says whether rendering works: 0 if it does, 5 if not.")
public final class DoctorCommand implements Callable<Integer> {
    private final Environment environment;
    private final GraphicsProbe graphics;

    @Spec
    private CommandSpec specification;

    public DoctorCommand(Environment environment, GraphicsProbe graphics) {
        this.environment = environment;
        this.graphics = graphics;
    }

    @Override
    public Integer call() {
        List<Check> checks = new ArrayList<>(Machine.examine(environment));
        List<Check> rendering = examineGraphics();
        checks.addAll(rendering);
        print(checks, specification.commandLine().getOut());
        return rendering.stream().allMatch(Check::isOk) ? ExitCode.OK.code() : ExitCode.NO_GRAPHICS.code();
    }

    private List<Check> examineGraphics() {
        try {
            return graphics.examine();
        } catch (GraphicsException failure) {
            return List.of(Check.failed("Graphics", "not usable", failure.getMessage()));
        }
    }

    private static void print(List<Check> checks, PrintWriter out) {
        int width =
                checks.stream().mapToInt(check -> check.name().length()).max().orElse(0);
        for (Check check : checks) {
            String name = check.name() + " ".repeat(width - check.name().length());
            out.println((check.isOk() ? "ok    " : "FAIL  ") + name + "  " + check.value());
            check.remedy().ifPresent(remedy -> out.println(" ".repeat(6 + width + 2) + remedy));
        }
        out.flush();
    }
}
