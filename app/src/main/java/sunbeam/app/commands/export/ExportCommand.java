package sunbeam.app.commands.export;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.SettingOptions;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;

/** {@code sunbeam export}: the table of colors as a file for other programs. */
@Command(
        name = "export",
        header = "Write a surface's table of colors for other programs.",
        description =
                "Write the colors C(u, v, w) that a surface diffracts (ensemble's average, D65, 2-degree observer) for"
                        + " every light and view, as a table for other programs: the finest that --size holds, of light whose"
                        + " coherence length is that which was asked for or shorter, so that orders are wider. Each output says"
                        + " what it holds and how far it is from the exact reference. See docs/export.md.")
public final class ExportCommand implements Callable<Integer> {
    private static final double SMALLEST_ANGLE = 5;
    private static final int MOST_SAMPLES = 10_000;
    private static final long SEED = 3;
    // Of Java's heap, what a table's numbers may take; writers need as much again.
    private static final int HEAP_SHARE = 3;

    private final Environment environment;

    @Parameters(paramLabel = "PATCH", description = "A built-in patch, a descriptor (.json) or a scan.")
    private String patch;

    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofSeveral();

    @Mixin
    private final TableOptions table = new TableOptions();

    @Mixin
    private ForceOption force;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            required = true,
            description =
                    "npz: arrays for NumPy. html: a page with a map and a sphere under a light that the mouse moves."
                            + " glsl: a folder with a function in GLSL, its table as KTX2 and EXR, and a page that uses it."
                            + " osl: a folder with a shader in Open Shading Language and its table as EXR.")
    private Format format;

    @Option(
            names = "--channels",
            paramLabel = "COLORS",
            description = "Of npz: xyz (default) or rec709, linear and negative where a color is outside of its gamut.")
    private NpzTable.Channels channels;

    @Option(
            names = "--theta-max",
            paramLabel = "ANGLE",
            defaultValue = "90",
            description =
                    "Largest angle of light and view to the normal in degrees, 5 to 90. Default: ${DEFAULT-VALUE}.")
    private double largestAngle;

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            description = "Largest size of the output. Default: 100MB; 1MB for html, 50MB for glsl and osl.")
    private String size;

    @Option(
            names = "--samples",
            paramLabel = "N",
            defaultValue = "4",
            description = "Pairs of directions at which the exact reference is evaluated, half of them on orders, 0 to "
                    + MOST_SAMPLES + ": one takes half a minute on a scan. Default: ${DEFAULT-VALUE}.")
    private int samples;

    @Option(
            names = "--output",
            paramLabel = "OUT",
            required = true,
            description = "The file; for glsl and osl, the folder.")
    private Path output;

    @Spec
    private CommandSpec specification;

    /** Tolerance and coherence length. */
    private static final class TableOptions extends SettingOptions {
        TableOptions() {
            super(
                    List.of(TOLERANCE, COHERENCE_LENGTH),
                    Map.of(TOLERANCE, "0.02, for html, glsl and osl 0.05; steps of the table grow with its root"));
        }
    }

    /** What can be written. */
    enum Format {
        NPZ("100MB", 0.02),
        HTML("1MB", 0.05),
        GLSL("50MB", 0.05),
        OSL("50MB", 0.05);

        private final String size;
        private final double tolerance;

        Format(String size, double tolerance) {
            this.size = size;
            this.tolerance = tolerance;
        }

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        TableWriter writer(NpzTable.Channels channels, double tolerance) {
            return switch (this) {
                case NPZ -> new NpzTable(channels == null ? NpzTable.Channels.XYZ : channels);
                case HTML -> new HtmlTable(tolerance);
                case GLSL -> new FolderTable(FolderTable.Language.GLSL);
                case OSL -> new FolderTable(FolderTable.Language.OSL);
            };
        }
    }

    public ExportCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        Choices choices = table.choices();
        return choices.located(() -> export(choices));
    }

    private int export(Choices asked) {
        if (!(largestAngle >= SMALLEST_ANGLE && largestAngle <= 90)) {
            throw new UsageException("--theta-max " + largestAngle + " is out of range; give 5 to 90");
        }
        if (samples < 0 || samples > MOST_SAMPLES) {
            throw new UsageException("--samples " + samples + " is out of range; give 0 to " + MOST_SAMPLES);
        }
        long most = most();
        double tolerance = asked.has(TOLERANCE) ? asked.get(TOLERANCE) : format.tolerance;
        TableWriter writer = format.writer(channels, tolerance);
        writer.check(output, force.overwrite());
        PrintWriter err = specification.commandLine().getErr();
        DiffractionSetup setup = new DiffractionSetup(patchOptions.load(patch, asked), environment, err);
        Choices choices =
                setup.seen(asked.with(Methods.METHOD, TableMethod.TYPE).with(AVERAGE, Average.ENSEMBLE), err);
        ColorTablePlan plan = new TableMethod(tolerance, GaussianArea.of(choices))
                .plan(setup.surface(), VisibleRange.all())
                .colorTable()
                .orElseThrow();
        GridBaker baker = new GridBaker(setup, plan, tolerance);
        ColorGrid grid = baker.finest(
                        new GridShape.AngleRange(Math.toRadians(largestAngle)), new Limits(writer, output, most))
                .orElseThrow(() -> new UsageException("--size " + (size == null ? format.size : size)
                        + " holds no table of this surface, however wide its orders; give more"));
        ColorGrid read = writer.asRead(grid);
        TableMethod seen = new TableMethod(tolerance, grid.level().area());
        GridErrors errors = GridErrors.of(
                read,
                setup.exact(seen),
                baker.source(grid.level(), done -> {}),
                new DirectionSampler(
                        setup.patch().heights(), grid.level().area().window(), SEED),
                samples);
        TableText text = new TableText(setup, choices.get(COHERENCE_LENGTH), read, errors);
        List<Path> written = writer.write(output, force.overwrite(), grid, baker, text);
        PrintWriter out = StandardOutput.reports(specification.commandLine().getOut(), err, output);
        out.println(text.summary());
        out.println(text.error());
        written.forEach(file -> out.println(StandardOutput.name(file)));
        if (errors.sums().median() > tolerance) {
            err.println(Messages.error("the tolerance of " + tolerance
                    + " is missed in the median; give a finer --tolerance and, for room, a larger --size"));
            return ExitCode.TOLERANCE_MISSED.code();
        }
        return ExitCode.OK.code();
    }

    private long most() {
        if (channels != null && format != Format.NPZ) {
            throw new UsageException("--channels is for --format npz; others hold square roots, which negative channels"
                    + " of Rec. 709 have not");
        }
        try {
            return ByteSize.parse(size == null ? format.size : size);
        } catch (IllegalArgumentException wrong) {
            throw new UsageException("--size " + wrong.getMessage());
        }
    }

    /**
     * What the output may take.
     *
     * @param most bytes of the file
     */
    private record Limits(TableWriter writer, Path output, long most) implements GridBaker.Limit {
        @Override
        public boolean mayHold(GridShape shape) {
            long bytes = writer.leastBytes(shape);
            long free = output.toAbsolutePath().getParent().toFile().getUsableSpace();
            if (bytes <= most && bytes > free && !StandardOutput.isMeant(output)) {
                throw new OutputException("cannot write " + output + ": it takes " + ByteSize.format(bytes) + " and "
                        + ByteSize.format(free) + " are free; give a --size that is less, or choose another folder");
            }
            return bytes <= most
                    && shape.allTexels() * 12 < Runtime.getRuntime().maxMemory() / HEAP_SHARE;
        }

        @Override
        public boolean holds(ColorGrid grid) {
            return writer.bytes(grid) <= most;
        }

        @Override
        public GridShape stored(GridShape shape) {
            return writer.fitted(shape);
        }
    }
}
