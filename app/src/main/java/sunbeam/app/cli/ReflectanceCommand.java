package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.PatchOptions.IndexOption;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.work.Progress;

/** Command {@code sunbeam reflectance}: evaluates a list of directions, to compare with other programs. */
@Command(
        name = "reflectance",
        header = "Evaluate a list of directions: CSV in, CSV out.",
        description = "Evaluate a list of directions. The input is a CSV file with a header and the columns theta_i,"
                + " phi_i, theta_r, phi_r in degrees and, for one wavelength a row, wavelength in nm; other columns are"
                + " ignored. The output repeats these columns and adds power of the chosen --average, the same under"
                + " that average's name (power_coherent or power_ensemble), rho and brdf (1/sr, without mask); without"
                + " wavelengths, X, Y, Z of power and the gain that turns them into rho. See docs/conventions.md.",
        footer = {"  sunbeam reflectance blaze --directions list.csv --output colors.csv"})
public final class ReflectanceCommand extends FileCommand {
    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private final SettingOptions turn = new SettingOptions(List.of(SceneSettings.ROTATE_PATCH, SceneSettings.ENERGY));

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private IndexOption index;

    @Mixin
    private CertifyOption certify;

    @Option(
            names = "--directions",
            paramLabel = "IN.csv",
            required = true,
            description = "The directions; - is standard input.")
    private Path directions;

    @Option(names = "--both-averages", description = "Write power_coherent and power_ensemble, whichever is chosen.")
    private boolean bothAverages;

    @Option(names = "--output", paramLabel = "OUT.csv", required = true, description = "The results.")
    private Path output;

    @Override
    public Integer call() {
        Choices choices = methodOptions.choices();
        return choices.located(() -> tabulate(choices));
    }

    private int tabulate(Choices asked) {
        certify.check(Methods.of(asked));
        Ending.CSV.require("--output", output);
        DirectionList list =
                DirectionList.read(directions).seenByTurned(turn.choices().get(SceneSettings.ROTATE_PATCH));
        if (list.spectral() && asked.get(Methods.METHOD).equals(TableMethod.TYPE)) {
            throw DiffractionSetup.withoutPower();
        }
        UsageException.throwIf(
                bothAverages && !list.spectral(),
                "--both-averages needs a power, which " + directions
                        + " has not: give it the column wavelength, or leave the option out");
        RefractiveIndex material = material(list);
        AtomicFile.checkWritable(output, overwrite());
        PrintWriter err = err();
        PrintWriter out = out(output);
        DiffractionSetup loaded = new DiffractionSetup(patchOptions.load(asked, environment(), err), environment(), err)
                .withLight(LightTable.of(asked));
        Choices choices = loaded.limitToScan(asked, err);
        Optional<EnergyDivisor> divisor =
                turn.choices().get(SceneSettings.ENERGY).divisor(loaded.patch().heights(), material, choices);
        DiffractionSetup setup = divisor.isEmpty() || list.spectral()
                ? loaded
                : loaded.withLight(divisor.get().under(light(list), loaded.cie()));
        Method method = Methods.of(choices);
        boolean ensemble = choices.get(MethodSettings.AVERAGE) == Average.ENSEMBLE;
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("patch", setup.patch().name());
        report.put("source", setup.patch().source());
        report.put("method", method.type().label());
        report.put("options", Methods.describe(choices));
        report.put("index", index.describe(material));
        report.put("directions", list.size());
        Evaluator evaluator = new Evaluator(list, setup.progress());
        ExactLight exact = setup.exact(method);
        Gain gain = ReflectionPart.gain(material, setup.cie(), method.fresnel().exponent());
        if (method instanceof ReferenceMethod) {
            write(list, ensemble, evaluator.radiances(gain, exact.window(), ensemble, evaluator.evaluate(exact)));
            json.print(out, report, List.of(output));
            return ExitCode.OK.code();
        }
        MethodPlan plan = method.plan(setup.surface(), VisibleRange.of(list.pairs()));
        methodOptions.print("", plan, err);
        ShaderTables tables = setup.tables(plan, list.spectral() ? MethodUse.SPECTRAL : MethodUse.COLOR);
        methodOptions.printTrial(tables.trial(), err);
        List<double[]> results = evaluator.evaluate(tables);
        Optional<Certificate> certificate = certify.count()
                .map(count -> evaluator.certify(exact, results, count, choices.get(MethodSettings.TOLERANCE)));
        List<double[]> radiances = evaluator.radiances(gain, exact.window(), ensemble, results);
        write(list, ensemble, evaluator.divided(divisor, radiances));
        report.put("plan", plan.summary());
        certificate.ifPresent(stated -> report.put("certificate", JsonOption.fields(stated)));
        json.print(out, report, List.of(output));
        return CertifyOption.judge(certificate, plan, choices, json.text(out), err)
                .code();
    }

    /** Returns the direction of light of all rows, by which their colors are divided over wavelength. */
    private Direction light(DirectionList list) {
        Direction light = list.pair(0).wi();
        UsageException.throwIf(
                list.pairs().stream().anyMatch(pair -> !pair.wi().equals(light)),
                "--energy conserve divides by direction of light and wavelength: give " + directions
                        + " one light, or the column wavelength");
        return light;
    }

    private RefractiveIndex material(DirectionList list) {
        RefractiveIndex material = index.parse();
        UsageException.throwIf(
                !material.isConstant() && !list.spectral(),
                "--index by wavelength leaves X, Y, Z no gain that is one number; give a number, or " + directions
                        + " the column wavelength");
        return material;
    }

    /** @param results rows of X, Y, Z, gain; or coherent power, ensemble-averaged power, rho, BRDF */
    private void write(DirectionList list, boolean ensemble, List<double[]> results) {
        Map<String, Integer> columns = new LinkedHashMap<>();
        if (list.spectral()) {
            columns.put("power", ensemble ? 1 : 0);
            if (bothAverages || !ensemble) {
                columns.put("power_coherent", 0);
            }
            if (bothAverages || ensemble) {
                columns.put("power_ensemble", 1);
            }
            columns.put("rho", 2);
            columns.put("brdf", 3);
        } else {
            List.of("X", "Y", "Z", "gain").forEach(name -> columns.put(name, columns.size()));
        }
        List<String> header = new ArrayList<>(list.columns());
        header.addAll(columns.keySet());
        StreamContent table = CsvWriter.numbers(header, list.size(), row -> {
            DoubleStream added = columns.values().stream().mapToDouble(column -> results.get(row)[column]);
            return DoubleStream.concat(Arrays.stream(list.row(row)), added).toArray();
        });
        AtomicFile.write(output, overwrite(), table);
    }

    /** Evaluates rows of directions: with a wavelength to coherent and ensemble power; without, to X, Y, Z of power. */
    record Evaluator(DirectionList list, ProgressDisplay display) {
        private static final int RHO = 2;
        private static final int BRDF = 3;

        List<double[]> evaluate(ShaderTables tables) {
            List<DirectionQuery> queries = IntStream.range(0, list.size())
                    .mapToObj(row -> new DirectionQuery(list.pair(row), list.spectral() ? list.wavelength(row) : 0))
                    .toList();
            try (RenderContext context = RenderContext.offscreen();
                    UploadedTables method = UploadedTables.upload(context, tables);
                    DirectionsRenderer renderer = new DirectionsRenderer(context, method, list.spectral());
                    Progress progress = display.start("Directions", list.size())) {
                return renderer.evaluate(queries, progress::step).stream()
                        .map(values -> new double[] {values[0], values[1], values[2]})
                        .toList();
            }
        }

        List<double[]> evaluate(ExactLight light) {
            return map(
                    "Reference",
                    row -> list.spectral()
                            ? spectral(light, row)
                            : light.xyz(list.pair(row), ExactLight.Quadrature.EXACT));
        }

        private List<double[]> map(String label, Function<Integer, double[]> values) {
            return display.map(label, IntStream.range(0, list.size()).boxed().toList(), values);
        }

        /** Compares results of the shaders with the reference at random rows: X, Y, Z, or the power under the method's average. */
        Certificate certify(ExactLight light, List<double[]> results, int count, double tolerance) {
            int from = list.spectral() && light.ensemble() ? 1 : 0;
            int to = list.spectral() ? from + 1 : 3;
            return Certificate.ofRows(
                    display,
                    list.size(),
                    count,
                    row -> {
                        double[] exact = list.spectral()
                                ? new double[] {light.power(list.pair(row), list.wavelength(row))}
                                : light.xyz(list.pair(row), ExactLight.Quadrature.INTEGRATED);
                        return new Comparison(Arrays.copyOfRange(results.get(row), from, to), exact, 1);
                    },
                    list.spectral() ? "power" : "XYZ",
                    tolerance);
        }

        /**
         * Adds to powers rho and BRDF, or to X, Y, Z the gain. Rho is relative to a flat mirror of the material at normal incidence (for a
         * tabulated index, to its mean weighted by luminance).
         */
        List<double[]> radiances(Gain gain, CoherenceWindow window, boolean ensemble, List<double[]> results) {
            return IntStream.range(0, list.size())
                    .mapToObj(row -> radiances(gain, window, ensemble, row, results.get(row)))
                    .toList();
        }

        private double[] radiances(Gain gain, CoherenceWindow window, boolean ensemble, int row, double[] values) {
            DirectionPair pair = list.pair(row);
            double wavelength = list.spectral() ? list.wavelength(row) : CieTable.MINIMUM_WAVELENGTH;
            double unit = gain.relativeRadiance(pair, wavelength);
            if (!list.spectral()) {
                return new double[] {values[0], values[1], values[2], unit};
            }
            double power = values[ensemble ? 1 : 0];
            return new double[] {values[0], values[1], unit * power, gain.brdf(pair, window, wavelength) * power};
        }

        /** Divides rho and BRDF of rows with a wavelength; the colors of other rows are under divided light. */
        List<double[]> divided(Optional<EnergyDivisor> divisor, List<double[]> results) {
            if (divisor.isEmpty() || !list.spectral()) {
                return results;
            }
            return map("Energy", row -> {
                double[] values = results.get(row).clone();
                double sent = divisor.get().at(list.pair(row).wi(), list.wavelength(row));
                values[RHO] /= sent;
                values[BRDF] /= sent;
                return values;
            });
        }

        private double[] spectral(ExactLight light, int row) {
            Power power = light.powers(list.pair(row), list.wavelength(row));
            return new double[] {power.coherent(), power.ensemble()};
        }
    }
}
