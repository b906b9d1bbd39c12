package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.PatchOptions.TaskPart;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.MemoryException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/** Command {@code sunbeam sample}: writes random rows of light, view and color. */
@Command(
        name = "sample",
        header = "Draw random lights and views with their colors and densities: data for learning.",
        description =
                "Write random rows: light and view (unit vectors in the tangent frame), X, Y, Z of the power that is"
                        + " diffracted (ensemble's average), or a wavelength, power and BRDF, and the probability density by which"
                        + " they were drawn, most of them on orders. A row depends on --seed and its number alone, so that the parts"
                        + " of --task are the whole, bit for bit. No OpenGL is needed. See docs/export.md.",
        footer = {"  sunbeam sample blaze --count 1000000 --output rows.npz"})
public final class SampleCommand extends FileCommand {
    private static final long MOST_ROWS = 1_000_000_000;
    private static final int MOST_OF_FILE = 100_000_000;
    // Divisor of the heap: rows may take half of it; tables need the rest.
    private static final int HEAP_DIVISOR = 2;
    // Copies of all rows that are in memory at once: the HDF5 library takes arrays of arrays, and copies them.
    private static final int HDF5_COPIES = 3;

    @Mixin
    private final PatchOptions patchOptions = new PatchOptions();

    @Mixin
    private final SettingOptions table = MethodOptions.ofTables(Map.of());

    @Mixin
    private CertifyOption certify;

    @Option(
            names = "--count",
            paramLabel = "N",
            required = true,
            description = "Rows of all parts together, 1 to " + MOST_ROWS + ".")
    private long count;

    @Option(
            names = "--channels",
            paramLabel = "CHANNELS",
            defaultValue = "xyz",
            description = "xyz: X, Y, Z of power. spectral: a wavelength per row, its power and BRDF."
                    + " Default: ${DEFAULT-VALUE}.")
    private RowKind channels;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "Whole number that all rows depend on. Default: ${DEFAULT-VALUE}.")
    private long seed;

    @Option(
            names = "--task",
            paramLabel = "I/N",
            defaultValue = "1/1",
            description = "Write the I-th of N parts of the rows. Default: ${DEFAULT-VALUE}.")
    private String task;

    @Option(
            names = "--output",
            paramLabel = "OUT",
            required = true,
            description = "The rows: NumPy's archive (.npz) or HDF5 (.h5).")
    private Path output;

    enum RowKind {
        XYZ,
        SPECTRAL;

        @Override
        public String toString() {
            return ValueKind.name(this);
        }
    }

    @Override
    public Integer call() {
        Choices choices = table.choices();
        return choices.located(() -> sample(choices));
    }

    private int sample(Choices asked) {
        UsageException.requireWithin("--count", count, 1, MOST_ROWS);
        certify.count();
        if (channels == RowKind.SPECTRAL) {
            LightTable.requireNone(asked, MethodSettings.LIGHT);
        }
        TaskPart part = TaskPart.parse(task);
        Ending.ROWS.require("--output", output);
        boolean hdf5 = Ending.HDF5.isOf(output);
        int rows = rows(part);
        AtomicFile.checkWritable(output, overwrite());
        requireRoom(rows, hdf5);
        DiffractionSetup setup =
                new DiffractionSetup(patchOptions.load(asked), environment(), err()).withLight(LightTable.of(asked));
        Choices choices = setup.limitToScan(
                asked.with(Methods.METHOD, TableMethod.TYPE).with(MethodSettings.AVERAGE, Average.ENSEMBLE), err());
        TableMethod method = new TableMethod(choices.get(MethodSettings.TOLERANCE), GaussianArea.of(choices));
        ColorTablePlan plan =
                method.plan(setup.surface(), VisibleRange.all()).colorTable().orElseThrow();
        err().println("plan: " + plan.plan().summary() + "; " + rows + " rows");
        err().flush();
        PowerSpectrum spectrum = PowerSpectrum.of(
                setup.fourier(plan.spectrum().orElseThrow()), new ErrorBudget(plan.tolerance()).powerBasis());
        Optional<Certificate> certificate;
        Map<String, Object> made = metadata(setup, method, plan, part);
        try (Progress progress = environment().progress().start("Rows", rows)) {
            SampleRows sampled = new SampleRows(plan, spectrum, setup.cie(), seed, progress);
            List<SampleRows.RowFile.Column> columns = channels == RowKind.XYZ
                    ? sampled.colorColumns()
                    : sampled.spectralColumns(method.area().window());
            long first = part.first(count);
            certificate =
                    certify.count().map(places -> certified(sampled, setup.exact(method), first, rows, places, method));
            certificate.ifPresent(stated -> made.put("error_beside_reference", JsonOption.fields(stated)));
            made.put("error_beside_sums_over_wavelengths", JsonOption.fields(differenceFromSums(sampled, first, rows)));
            SampleRows.RowFile file =
                    new SampleRows.RowFile(first, rows, columns, JsonOption.text(json.withCommand(made)));
            if (hdf5) {
                AtomicFile.writeFile(output, overwrite(), file::writeHdf5);
            } else {
                AtomicFile.write(output, overwrite(), file::writeNpz);
            }
        }
        PrintWriter out = out(output);
        json.print(out, made, List.of(output));
        return CertifyOption.judge(certificate, plan.plan(), choices, json.text(out), err())
                .code();
    }

    private ErrorStatistics differenceFromSums(SampleRows sampled, long first, int rows) {
        if (channels == RowKind.SPECTRAL) {
            return ErrorStatistics.of();
        }
        int checked = Math.min(rows, SampleRows.CHECKED_ROWS);
        try (Progress checks = environment().progress().start("Sums over wavelengths", checked)) {
            return sampled.differenceFromSums(first, rows, checked, checks);
        }
    }

    private int rows(TaskPart part) {
        long rows = part.end(count) - part.first(count);
        UsageException.throwIf(rows < 1, "--task " + task + " has no row of --count " + count + "; give fewer parts");
        UsageException.throwIf(
                rows > MOST_OF_FILE,
                "--count " + count + " makes " + rows + " rows a file, and " + MOST_OF_FILE
                        + " are the most; give parts by --task");
        return (int) rows;
    }

    private void requireRoom(int rows, boolean hdf5) {
        long bytes = SampleRows.RowFile.bytes(rows);
        long batch = SampleRows.RowFile.bytes(Math.min(rows, SampleRows.RowFile.BATCH));
        long heap = Runtime.getRuntime().maxMemory() / HEAP_DIVISOR;
        if (batch + (hdf5 ? HDF5_COPIES * bytes : 0) > heap) {
            throw new MemoryException("--count " + count + ": rows of " + ByteSize.format(bytes) + " as HDF5 take "
                    + ByteSize.format(HDF5_COPIES * bytes) + " of memory, and " + ByteSize.format(heap)
                    + " are there for them; give parts by --task, or an .npz");
        }
        AtomicFile.requireRoom(output, bytes, "it takes", "give fewer rows");
    }

    private Map<String, Object> metadata(
            DiffractionSetup setup, TableMethod method, ColorTablePlan plan, TaskPart part) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("program", "sunbeam " + Environment.version());
        fields.put("patch", setup.patch().name());
        fields.put("patch_sha256", setup.patch().heights().digest());
        fields.put("plan", plan.plan().summary());
        fields.put("tolerance", method.tolerance());
        fields.put("average", "ensemble: mean over all positions of the coherence window");
        fields.put("coherence_length_m", method.area().window().coherenceLength());
        fields.put("seed", seed);
        fields.put("count", count);
        fields.put("task", part.number() + "/" + part.parts());
        fields.put("first_row", part.first(count));
        fields.put("background_share", PairDensity.BACKGROUND);
        fields.put("directions", "unit vectors to light and viewer; x tangent, y bitangent, z normal");
        String density = "probability by solid angles of light and view%s: the mean of f / density estimates the"
                + " integral of f over both hemispheres%s";
        if (channels == RowKind.XYZ) {
            String light = setup.cie().description();
            fields.put(
                    "xyz",
                    "X, Y, Z of diffracted power in " + light + "; a flat mirror in specular direction has Y = 1");
            fields.put("density", Text.format(density, ", 1/sr^2", ""));
        } else {
            fields.put("wavelength", "nm, even in 380 to 780");
            fields.put("power", "1: a flat mirror in specular direction");
            fields.put("brdf", "1/sr, without mask; keratin's reflectance");
            fields.put("density", Text.format(density, " and by wavelength, 1/(sr^2 nm)", " and 380 to 780 nm"));
        }
        return fields;
    }

    private Certificate certified(
            SampleRows sampled, ExactLight exact, long first, int rows, int places, TableMethod method) {
        return Certificate.ofRows(
                environment().progress(),
                rows,
                places,
                row -> {
                    SampleRows.Row one = sampled.row(first + row);
                    if (channels == RowKind.XYZ) {
                        double[] xyz = Comparison.xyz(sampled.xyz(first + row, 1), 0);
                        return new Comparison(xyz, exact.xyz(one.pair(), ExactLight.Quadrature.INTEGRATED), 1);
                    }
                    return Comparison.ofPower(sampled.power(one), exact.power(one.pair(), one.wavelength()));
                },
                channels == RowKind.XYZ ? "XYZ" : "power",
                method.tolerance());
    }
}
