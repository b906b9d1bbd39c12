package sunbeam.app.directions;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.certificate.Certificate;
import sunbeam.app.certificate.CertifyOption;
import sunbeam.app.cli.Environment;
import sunbeam.app.cli.ExitCode;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.CsvWriter;
import sunbeam.app.output.ForceOption;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.MethodOptions;
import sunbeam.app.setup.MethodRequest;
import sunbeam.app.setup.Methods;
import sunbeam.app.setup.PatchOptions;
import sunbeam.app.setup.PlanOptions;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;

/** {@code sunbeam reflectance}: numbers for a list of directions, the interface by which anybody can check Sunbeam. */
@Command(
        name = "reflectance",
        header = "Evaluate a list of directions: CSV in, CSV out.",
        description = "Evaluate a list of directions. The input is a CSV file with a header and the columns theta_i,"
                + " phi_i, theta_r, phi_r in degrees and, for one wavelength a row, wavelength in nm; other columns are"
                + " ignored. The output repeats these columns and adds power, power_ensemble, rho and brdf (1/sr,"
                + " without mask); without wavelengths, X, Y, Z of power and the gain that turns them into rho."
                + " See docs/reflectance.md.")
public final class ReflectanceCommand implements Callable<Integer> {
    private static final List<String> SPECTRAL_RESULTS = List.of("power", "power_ensemble", "rho", "brdf");
    private static final List<String> COLOUR_RESULTS = List.of("X", "Y", "Z", "gain");

    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private PlanOptions planOptions;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private CertifyOption certify;

    @Mixin
    private ForceOption force;

    @Option(names = "--directions", paramLabel = "IN.csv", required = true, description = "The directions.")
    private Path directions;

    @Option(names = "--output", paramLabel = "OUT.csv", required = true, description = "The results.")
    private Path output;

    @Spec
    private CommandSpec specification;

    public ReflectanceCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        MethodRequest method = methodOptions.request();
        PlanRequest request = planOptions.request(method.kind());
        if (certify.count().isPresent() && method.kind() == MethodKind.REFERENCE) {
            throw new UsageException("--certify compares with --method reference; leave out one of them");
        }
        DirectionList list = DirectionList.read(directions);
        AtomicFile.checkWritable(output, force.overwrite());
        DiffractionSetup setup = new DiffractionSetup(
                patchOptions, environment, specification.commandLine().getErr());
        PrintWriter out = specification.commandLine().getOut();
        List<double[]> results = evaluate(setup, method, request, list);
        Optional<Certificate> certificate = certify.certificate(count -> new ExactRows(setup, method, request, list)
                .certifier(results)
                .certify(list.size(), count, request.tolerance()));
        write(list, results);
        out.println(output);
        return certificate
                .map(stated -> CertifyOption.judge(
                        stated, out, specification.commandLine().getErr()))
                .orElse(ExitCode.OK)
                .code();
    }

    private List<double[]> evaluate(
            DiffractionSetup setup, MethodRequest method, PlanRequest request, DirectionList list) {
        if (method.kind() != MethodKind.REFERENCE) {
            MethodPlan plan = Methods.plan(setup, method, request, VisibleRange.of(list.geometries()));
            planOptions.print(plan, specification.commandLine().getErr());
            return new GpuDirections(setup, plan).evaluate(list);
        }
        return method.replicas().isPresent()
                ? new ReplicaDirections(setup, method, request).evaluate(list)
                : new ReferenceDirections(setup, request).evaluate(list);
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
