package sunbeam.app.setup;

import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.cli.Environment;
import sunbeam.app.cli.ExitCode;
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.DefaultName;
import sunbeam.app.output.ForceOption;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.TableFile;

/** {@code sunbeam precompute}: the Fourier tables of a patch as a file for other programs. */
@Command(
        name = "precompute",
        header = "Write the Fourier tables of a patch as HDF5.",
        description =
                "Write the Fourier tables of a patch to one HDF5 file: the DFT of every term T_n(h) of the expansion"
                        + " of exp(i k w h), complex float32, cropped to what any pair of directions can see. The file says what"
                        + " its numbers mean; see docs/table-format.md. Made once, the"
                        + " table is kept in the cache folder, as are those of the other commands.")
public final class PrecomputeCommand implements Callable<Integer> {
    private final Environment environment;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private PlanOptions planOptions;

    @Mixin
    private ForceOption force;

    @Option(names = "--output", paramLabel = "FILE.h5", description = "The file. Default: the patch's name.")
    private Path output;

    @Spec
    private CommandSpec specification;

    public PrecomputeCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        DiffractionSetup setup = new DiffractionSetup(
                patchOptions, environment, specification.commandLine().getErr());
        Path file = output != null
                ? output
                : DefaultName.choose(Path.of(""), setup.patch().name(), "h5", force.overwrite());
        AtomicFile.checkWritable(file, force.overwrite());
        Plan plan = setup.plan(planOptions.request(), VisibleRange.all());
        long start = System.nanoTime();
        FourierTable table = setup.table(plan);
        double seconds = (System.nanoTime() - start) * 1e-9;
        AtomicFile.writeFile(file, force.overwrite(), path -> TableFile.write(path, table));
        specification
                .commandLine()
                .getOut()
                .printf(
                        Locale.ROOT,
                        "%d %s terms of %d x %d bins, %.1f MB, made or read in %.2f s%n%s%n",
                        table.terms(),
                        table.kind().label(),
                        table.bandX().count(),
                        table.bandY().count(),
                        table.bytes() * 1e-6,
                        seconds,
                        file);
        return ExitCode.OK.code();
    }
}
