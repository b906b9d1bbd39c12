package sunbeam.app.cli;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.OrderTable.Incidence;
import sunbeam.app.cli.OrderTable.Series;
import sunbeam.app.cli.PatchOptions.IndexOption;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.OrderLattice;
import sunbeam.precompute.analysis.OrderLight;
import sunbeam.precompute.analysis.OrderSpectrum;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Command {@code sunbeam orders}: how much light a surface sends into each diffraction order. */
@Command(
        name = "orders",
        header = "Tell how much light goes into each diffraction order.",
        description = "Tell how much light a grating, a lattice or a scan with a period sends into each diffraction"
                + " order: numbers, direction and efficiency, the share of the incident light, over wavelength and"
                + " angle of incidence. Writes them as .csv and .json, and a plot (.png) with their sum beside the"
                + " reflectance of a flat mirror. The efficiency of a scan is the light around the order, with its 95"
                + " %% interval. A patch without a period: exit code 4. See docs/evaluation.md.",
        footer = {"  sunbeam orders blaze --theta-i 0:60:10", "  sunbeam orders scan.gwy --theta-i 30 --index 0.97+6.5i"
        })
public final class OrdersCommand extends FileCommand {
    private static final double LARGEST_THETA = 89.9;
    // Height of a plot relative to its width.
    private static final double RATIO = 0.6;
    // Least height, pixels: the legend of a narrow plot has more lines.
    private static final int LOWEST = 800;
    private static final int MOST_PLOTS = 12;
    // Excess of light over a mirror's, relative to it, that rounding does not make.
    private static final double ROUNDING = 1e-6;
    // Limits of a patch's orders (500 MB for a relief of 1 um), of evaluated orders (minutes), and of written ones.
    private static final long MOST_ORDERS = 4_000_000;
    private static final double DEEPEST = 20e-6;
    private static final long MOST_EVALUATIONS = 4_000_000_000L;
    private static final double MOST_RESULTS = 5e5;

    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofMany();

    @Mixin
    private ResumeOption resume;

    @Mixin
    private final SettingOptions azimuth = SettingOptions.overriding(
            List.of(LightOptions.PHI_I), Map.of(LightOptions.PHI_I, "across the lines of the grating"));

    @Mixin
    private final SettingOptions light =
            new SettingOptions(List.of(MethodSettings.ILLUMINANT, MethodSettings.OBSERVER));

    @Mixin
    private IndexOption index;

    @Option(
            names = "--theta-i",
            paramLabel = "ANGLES",
            defaultValue = "0",
            description = "Angle of the light to the normal in degrees, or angles MIN:MAX:STEP, within 0 to 89.9."
                    + " Default: ${DEFAULT-VALUE}.")
    private Range thetas;

    @Option(
            names = "--wavelengths",
            paramLabel = "MIN:MAX:STEP",
            defaultValue = "380:780:5",
            description = "Wavelengths in nm, or one, within 380..780. Default: ${DEFAULT-VALUE}.")
    private Range wavelengths;

    @Mixin
    private PageOptions page;

    @Option(
            names = "--panel",
            paramLabel = "NAME",
            description = "Draw one panel alone, without heading, at the first angle of the light:"
                    + " ${COMPLETION-CANDIDATES}.")
    private Panel panel;

    @Option(
            names = "--output",
            paramLabel = "NAME",
            description = "Name of the files; an ending .json or .csv is left out, as each file has its own; .png, .pdf"
                    + " or .svg is that of the plot. Default: PATCH-orders.")
    private Path output;

    /** Parts of the picture. */
    enum Panel {
        EFFICIENCY
    }

    @Override
    public Integer call() {
        resume.requireMany();
        Choices choices = light.choices().over(azimuth.choices());
        return choices.located(() -> run(choices));
    }

    private int run(Choices choices) {
        thetas.requireWithin("--theta-i", 0, LARGEST_THETA, "degrees");
        wavelengths.requireWithin("--wavelengths", CieTable.FIRST_NANOMETER, CieTable.LAST_NANOMETER, "nm");
        RefractiveIndex material = index.parse();
        CieTable cie = LightTable.of(choices);
        page.width();
        // A name that cannot be written is refused before the patch is read.
        if (output != null) {
            writableGroup(output, "");
        }
        Patch patch = patchOptions.load(Choices.none());
        Messages.scanWarning(patch.name(), patch.warnings(), "inspect --explain")
                .ifPresent(err()::println);
        FileGroup files = writableGroup(output, patch.name() + "-orders");
        GratingPeriod period = cachedPeriod(patch);
        InputException.refuseIf(
                !period.isSeen(),
                patch.name() + ": no orders without a period: "
                        + Verdict.of(patch, period, 0, 0).sentence());
        OrderTable table = table(patch, period, choices, material, cie);
        table.lines().forEach(json.text(out())::println);
        Map<String, Object> tree = table.tree();
        tree.put("index", index.describe(material));
        Map<String, String> text = Map.of("Title", patch.name() + ", diffraction orders", "Patch", patch.source());
        write(files, tree, table.csv(), plot(table), page.width(), text);
        return doubt(List.of(patch)).code();
    }

    private OrderTable table(
            Patch patch, GratingPeriod period, Choices choices, RefractiveIndex material, CieTable cie) {
        long orders = OrderSpectrum.orders(patch.heights());
        double relief = patch.heights().relief();
        // The terms of the expansion grow with the relief.
        InputException.refuseIf(
                relief > DEEPEST
                        || OrderSpectrum.amplitudes(patch.heights()) * Math.max(1, 0.5e6 * relief + 0.5) > MOST_ORDERS,
                patch.name() + ": " + patch.heights().describe() + " with a relief of " + Lengths.rounded(relief, 3)
                        + " have too many orders; --crop a smaller part, whose relief is at most 20 um");
        OrderLattice ofHeights = OrderLattice.of(patch, period);
        double phi =
                Math.toDegrees(choices.get(LightOptions.PHI_I, ofHeights.first().azimuth()));
        double[] meters =
                Arrays.stream(wavelengths.values()).map(nm -> nm / 1e9).toArray();
        double[] angles = thetas.values();
        List<Direction> directions = Arrays.stream(angles)
                .mapToObj(theta -> Direction.ofDegrees(theta, phi))
                .toList();
        OrderLattice lattice = ofHeights.ofSamples(patch, directions, meters[0]);
        long lights = (long) thetas.count() * wavelengths.count();
        double visible = lattice.most(CieTable.MINIMUM_WAVELENGTH);
        boolean sampled = patch.repetition() != Patch.Repetition.PERIODIC;
        String fewer = sampled ? "" : ", or --no-periodic, which adds up the light around each order of its lines";
        UsageException.throwIf(
                orders * lights > MOST_EVALUATIONS || visible * lights > MOST_RESULTS,
                Text.format(
                        "%d angles of --theta-i and %d --wavelengths are too many for this patch of %.0f orders; take larger steps%s",
                        thetas.count(), wavelengths.count(), visible, fewer));
        OrderSpectrum spectrum = new OrderSpectrum(patch.heights());
        List<Integer> numbers = IntStream.range(0, (int) lights).boxed().toList();
        List<OrderLight> all = environment().progress().map("Orders of " + patch.name(), numbers, i -> {
            Direction wi = directions.get(i / meters.length);
            return OrderLight.of(spectrum, lattice, material, wi, meters[i % meters.length], sampled);
        });
        List<Incidence> incidences = IntStream.range(0, angles.length)
                .mapToObj(i -> new Incidence(angles[i], all.subList(i * meters.length, (i + 1) * meters.length)))
                .toList();
        Verdict verdict = Verdict.of(patch, period, thetas.minimum(), phi - Math.toDegrees(period.azimuth()));
        return new OrderTable(patch, period, verdict, lattice, phi, incidences, cie);
    }

    private Drawing plot(OrderTable table) {
        Sheet sheet = new Sheet(page.pixels());
        if (panel == null) {
            sheet.heading(table.patch().name() + ": " + table.verdict().sentence());
        }
        List<Incidence> incidences = table.incidences();
        int angles = incidences.size();
        String azimuth = ", azimuth of the light " + OrderTable.written(table.phi()) + " degrees";
        if (incidences.get(0).lights().size() == 1 && angles > 1) {
            List<OrderLight> lights =
                    incidences.stream().flatMap(one -> one.lights().stream()).toList();
            String title = OrderTable.nanometers(lights.get(0)) + azimuth;
            String axis = "angle of incidence / degrees";
            ToDoubleFunction<OrderLight> theta =
                    light -> Math.toDegrees(Math.acos(light.wi().z()));
            return sheet.row(plot(title, axis, theta, lights, OrderTable.series(lights)))
                    .draw();
        }
        for (int i = 0; i < (panel == null ? angles : 1); i += (angles + MOST_PLOTS - 1) / MOST_PLOTS) {
            Incidence one = incidences.get(i);
            String title = "light at " + OrderTable.written(one.theta()) + " degrees" + azimuth;
            sheet.row(plot(title, "wavelength / nm", light -> 1e9 * light.wavelength(), one.lights(), one.orders()));
        }
        return sheet.draw();
    }

    private Drawing plot(
            String title, String axis, ToDoubleFunction<OrderLight> x, List<OrderLight> lights, List<Series> orders) {
        int height = (int) Math.max(LOWEST, RATIO * page.pixels());
        Plot plot = Plot.linear(title, axis, "share of the incident light", page.pixels(), height)
                .fromZero();
        for (Series series : OrderTable.shown(orders)) {
            plot.line(
                    "order " + series.order().in(lights.get(0).lattice()),
                    series.values(seen -> x.applyAsDouble(seen.light())),
                    series.values(seen -> seen.efficiency().value()));
        }
        double[] all = lights.stream().mapToDouble(x).toArray();
        double[] sums = lights.stream().mapToDouble(OrderLight::sum).toArray();
        double[] mirror = lights.stream().mapToDouble(OrderLight::mirror).toArray();
        boolean more = IntStream.range(0, sums.length).anyMatch(i -> sums[i] > mirror[i] * (1 + ROUNDING));
        return plot.line(more ? "all light (scalar theory, more than a mirror's)" : "all light", all, sums)
                .outline("flat mirror", all, mirror)
                .draw();
    }
}
