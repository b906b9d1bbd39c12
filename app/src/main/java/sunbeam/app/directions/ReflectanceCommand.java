package sunbeam.app.directions;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.cli.Environment;
import sunbeam.app.cli.ExitCode;
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.CsvWriter;
import sunbeam.app.output.ForceOption;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.PatchOptions;
import sunbeam.app.setup.PlanOptions;
import sunbeam.precompute.plan.PlanRequest;

/** {@code sunbeam reflectance}: numbers for a list of directions, the interface by which anybody can check Sunbeam. */
@Command(
        name = "reflectance",
        description = "Evaluate a list of directions. The input is a CSV file with a header and the columns theta_i,"
                + " phi_i, theta_r, phi_r in degrees and, for one wavelength a row, wavelength in nm; other columns are"
                + " ignored. The output repeats these columns and adds power, power_ensemble, rho and brdf (1/sr,"
                + " without mask); without wavelengths, X, Y, Z of power and the gain that turns them into rho."
                + " See docs/reflectance.md.")
public final class ReflectanceCommand implements Callable<Integer> {
    private static final List<String> SPECTRAL_RESULTS = List.of("power", "power_ensemble", "rho", "brdf");
    private static final List<String> COLOUR_RESULTS = List.of("X", "Y", "Z", "gain");

    /** Who evaluates. */
    private enum Method {
        REFERENCE,
        FULL
    }

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private PlanOptions planOptions;

    @Mixin
    private ForceOption force;

    @Option(names = "--directions", paramLabel = "IN.csv", required = true, description = "The directions.")
    private Path directions;

    @Option(names = "--output", paramLabel = "OUT.csv", required = true, description = "The results.")
    private Path output;

    @Option(
            names = "--method",
            paramLabel = "METHOD",
            defaultValue = "full",
            description = "full (default): one fragment a row, through the shader code that draws the maps. reference:"
                    + " direct sums in double precision on the processor; slow, the truth.")
    private Method method;

    @Spec
    private CommandSpec specification;

    public ReflectanceCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        PlanRequest request = planOptions.request();
        DirectionList list = DirectionList.read(directions);
        AtomicFile.checkWritable(output, force.overwrite());
        DiffractionSetup setup = new DiffractionSetup(
                patchOptions, environment, specification.commandLine().getErr());
        PrintWriter out = specification.commandLine().getOut();
        List<double[]> results = method == Method.REFERENCE
                ? new ReferenceDirections(setup, request).evaluate(list)
                : new GpuDirections(setup, request, plan -> planOptions.print(plan, out)).evaluate(list);
        write(list, results);
        out.println(output);
        return ExitCode.OK.code();
    }

    private void write(DirectionList list, List<double[]> results) {
        List<String> header = new ArrayList<>(list.columns());
        header.addAll(list.spectral() ? SPECTRAL_RESULTS : COLOUR_RESULTS);
        AtomicFile.write(output, force.overwrite(), stream -> {
            try (CsvWriter writer = new CsvWriter(stream, header)) {
                for (int row = 0; row < list.size(); row++) {
                    double[] given = list.row(row);
                    double[] computed = results.get(row);
                    double[] cells = new double[given.length + computed.length];
                    System.arraycopy(given, 0, cells, 0, given.length);
                    System.arraycopy(computed, 0, cells, given.length, computed.length);
                    writer.row(cells);
                }
            }
        });
    }
}
