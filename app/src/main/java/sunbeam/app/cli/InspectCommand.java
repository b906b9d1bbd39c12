package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.Colors;
import sunbeam.app.files.plot.HeatMap.Frame;
import sunbeam.app.files.plot.HeatMap.Values;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Command {@code sunbeam inspect}: reports the properties of a patch's heights, without computing colors. */
@Command(
        name = "inspect",
        header = "Look at a height map: verdict, relief, slopes, period.",
        description = "Look at a patch before rendering it: first what it is in one sentence, then size, relief,"
                + " roughness, slopes and its period; as text and as one picture with histogram and power spectrum.",
        footer = {
            "  sunbeam inspect scan.gwy",
            "  sunbeam inspect folder --output report",
            "  sunbeam inspect scan.png --width 65um --max-height 375nm"
        })
public final class InspectCommand extends FileCommand {
    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofMany();

    @Mixin
    private final SettingOptions light = new SettingOptions(List.of(LightOptions.THETA_I));

    @Mixin
    private ResumeOption resume;

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description = "The picture, or the folder of several. Default: a name made of the patch.")
    private Path output;

    @Option(
            names = "--explain",
            description =
                    "Say more: source, channels, faults, warnings in full, the model's error, the plan and its cost.")
    private boolean explain;

    @Override
    public Integer call() {
        resume.requireMany();
        Ending.PNG.require("--output", output);
        UsageException.throwIf(
                json.isGiven() && OutputFolder.isStandardOutput(output),
                "--json and --output - both want standard output; name a file for the picture");
        PrintWriter out = out(output);
        AtomicFile.checkWritable(output, overwrite());
        Patch loaded = patchOptions.load(Choices.none());
        Messages.printScan(loaded, loaded.warnings(), explain, err());
        Path picture = writable(output, "inspect-" + loaded.name() + ".png");
        double theta = Math.rint(1e9 * Math.toDegrees(light.choices().get(LightOptions.THETA_I))) / 1e9;
        Inspection inspection = Inspection.of(loaded, theta, explain || json.isGiven());
        List<String> lines = new ArrayList<>(inspection.lines());
        if (explain) {
            lines.addAll(inspection.explanation());
        }
        lines.forEach(json.text(out)::println);
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "Inspection of " + loaded.name());
        text.put("Patch", loaded.source());
        text.put("Verdict", inspection.verdict().sentence());
        // Also --json makes the plan, but writes the same picture as without it.
        inspection.plan().filter(summary -> explain).ifPresent(summary -> text.put("Plan", summary));
        InspectionSheet sheet = new InspectionSheet(inspection, loaded.scan(), lines.subList(1, lines.size()));
        Path place = PngWriter.write(picture, overwrite(output), sheet.draw().rasterize(), text);
        Map<String, Object> fields = inspection.fields();
        fields.put("thumbnail_px", sheet.thumbnail());
        json.print(out, fields, List.of(place));
        return doubt(List.of(loaded)).code();
    }

    private record InspectionSheet(Inspection inspection, HeightMap map, List<String> lines) {
        private static final int PANEL_WIDTH = Drawing.COLUMN / 2;
        private static final int LABELS = 130;
        private static final int PICTURE_HEIGHT = 600;
        private static final int PLOT_HEIGHT = 460;
        private static final int HISTOGRAM_BINS = 100;
        // Least width of a bin, meters, where all heights are equal.
        private static final double LEAST_STEP = 1e-12;
        // Share of the lowest and of the highest heights that the gray scale leaves out.
        private static final double DUST = 0.001;
        private static final int PROFILE_PERIODS = 12;
        private static final double MICROMETERS = 1e6;
        private static final double NANOMETERS = 1e9;
        // Lowest power of the color scale relative to the highest.
        private static final double SPAN = 1e-7;
        // Least range of frequencies that is drawn, 1/m: |(u, v)| = 2 at 780 nm.
        private static final double LEAST_SHOWN = 2 / 780e-9;
        // Least range of frequencies that is drawn, relative to that of the period.
        private static final double SHOWN_PER_PERIOD = 1.5;

        private Sheet text() {
            Sheet sheet = new Sheet(2 * PANEL_WIDTH)
                    .heading(inspection.patch().name() + ": "
                            + inspection.verdict().sentence());
            lines.forEach(line -> sheet.labeled(line, LABELS));
            return sheet;
        }

        /** Returns x, y, width and height of the heights and their spectrum in the picture, pixels. */
        List<Integer> thumbnail() {
            return List.of(0, text().height(), 2 * PANEL_WIDTH, PICTURE_HEIGHT);
        }

        Drawing draw() {
            return text().row(heights(), spectrum()).row(histogram(), profile()).draw();
        }

        private Drawing heights() {
            double[][] rows = new double[map.rows()][map.columns()];
            for (int row = 0; row < map.rows(); row++) {
                int mapRow = map.rows() - 1 - row;
                Arrays.setAll(rows[row], column -> map.at(column, mapRow) * NANOMETERS);
            }
            // Leaves out the lowest and highest 0.1 %: with a grain of dust in it, all else would be one gray.
            double[] heights = map.heights();
            double low = Quantiles.of(heights, DUST) * NANOMETERS;
            double high = Math.max(Quantiles.of(heights, 1 - DUST) * NANOMETERS, low + 1e-3);
            Colors colors = new Colors("", low, high, Plot.Scale.LINEAR, HeatMap.ColorMap.GRAY);
            double width = map.width() * MICROMETERS;
            double bar = Plot.round(0.25 * width);
            double[] x = {0, width};
            double[] y = {0, map.height() * MICROMETERS};
            return new HeatMap(
                            new Frame("Height / nm", "x / um", "y / um", PANEL_WIDTH, PICTURE_HEIGHT, true),
                            new Values(rows, x, y, colors, HeatMap.Reduction.MIDDLE))
                    .scaleBar(Lengths.format(bar / MICROMETERS), bar)
                    .draw();
        }

        private Drawing spectrum() {
            HeightSpectrum spectrum = inspection.spectrum();
            GratingPeriod period = inspection.period();
            double shown =
                    Math.max(LEAST_SHOWN, SHOWN_PER_PERIOD * period.wave().length());
            int reachX = (int) Math.min(spectrum.bandX().last(), Math.ceil(shown * spectrum.width()));
            int reachY = (int) Math.min(spectrum.bandY().last(), Math.ceil(shown * spectrum.height()));
            boolean profile = map.columns() == 1 || map.rows() == 1;
            // Power by the area of a bin, or by its length.
            double density = profile
                    ? NANOMETERS * NANOMETERS * MICROMETERS * (map.rows() == 1 ? spectrum.width() : spectrum.height())
                    : Math.pow(NANOMETERS, 4) * spectrum.width() * spectrum.height();
            double[][] rows = new double[2 * reachY + 1][2 * reachX + 1];
            for (int row = 0; row < rows.length; row++) {
                int jy = row - reachY;
                Arrays.setAll(rows[row], column -> density * spectrum.at(column - reachX, jy));
            }
            double largest =
                    Arrays.stream(rows).flatMapToDouble(Arrays::stream).max().orElse(0);
            double high = largest > 0 ? largest : 1;
            Colors colors = new Colors("", SPAN * high, high, Plot.Scale.LOGARITHMIC, HeatMap.ColorMap.VIRIDIS);
            double halfX = (reachX + 0.5) / spectrum.width() / MICROMETERS;
            double halfY = (reachY + 0.5) / spectrum.height() / MICROMETERS;
            double[] x = {-halfX, halfX};
            double[] y = {-halfY, halfY};
            String title = "Power spectral density / " + (profile ? "nm^2 um" : "nm^4");
            String axis = "periods per um along ";
            HeatMap picture = new HeatMap(
                    new Frame(title, axis + "x", axis + "y", PANEL_WIDTH, PICTURE_HEIGHT, true),
                    new Values(rows, x, y, colors, HeatMap.Reduction.LARGEST));
            if (period.hasWave()) {
                period.waves()
                        .forEach(wave -> picture.mark(
                                Lengths.rounded(wave.period(), 3), wave.x() / MICROMETERS, wave.y() / MICROMETERS));
            }
            return picture.draw();
        }

        private Drawing histogram() {
            double low = map.minimum();
            double step = Math.max(map.relief() / (HISTOGRAM_BINS - 1), LEAST_STEP);
            double[] shares = new double[HISTOGRAM_BINS];
            double one = 1 / (step * NANOMETERS * map.columns() * map.rows());
            // Heights count in two neighboring bins, by distance, so that the levels of an 8-bit scan are no comb.
            for (double height : map.heights()) {
                double place = (height - low) / step;
                int bin = Math.min(HISTOGRAM_BINS - 2, (int) place);
                shares[bin] += one * (1 - (place - bin));
                shares[bin + 1] += one * (place - bin);
            }
            double[] centers = IntStream.range(0, HISTOGRAM_BINS)
                    .mapToDouble(bin -> (low + bin * step) * NANOMETERS)
                    .toArray();
            return Plot.linear("Share of the surface per nm", "height / nm", "", PANEL_WIDTH, PLOT_HEIGHT)
                    .fromZero()
                    .line("share", centers, shares)
                    .draw();
        }

        /** Samples a line through the center at the finer of both pitches, as far as the patch reaches. */
        private Drawing profile() {
            GratingPeriod period = inspection.period();
            boolean column = map.columns() == 1;
            double direction = period.hasWave() ? period.azimuth() : column ? 0.5 * Math.PI : 0;
            double longest = period.hasWave() ? PROFILE_PERIODS * period.period() : Double.POSITIVE_INFINITY;
            double pitch = Math.min(map.pitchX(), map.pitchY());
            double cosine = Math.cos(direction);
            double sine = Math.sin(direction);
            int half = 0;
            while (half * pitch < 0.5 * longest && isInside((half + 1) * pitch * cosine, (half + 1) * pitch * sine)) {
                half++;
            }
            double[] positions = new double[2 * half + 1];
            double[] heights = new double[positions.length];
            for (int i = 0; i < positions.length; i++) {
                positions[i] = i * pitch * MICROMETERS;
                heights[i] = at((i - half) * pitch * cosine, (i - half) * pitch * sine) * NANOMETERS;
            }
            String title = Text.format(
                    "Profile through the center, %.1f\u00b0", Math.rint(10 * Math.toDegrees(direction)) / 10 + 0.0);
            return Plot.linear(title, "position / um", "height / nm", PANEL_WIDTH, PLOT_HEIGHT)
                    .line("heights", positions, heights)
                    .draw();
        }

        private boolean isInside(double x, double y) {
            return Math.abs(x) <= 0.5 * (map.columns() - 1) * map.pitchX()
                    && Math.abs(y) <= 0.5 * (map.rows() - 1) * map.pitchY();
        }

        private double at(double x, double y) {
            return map.at((int) Math.floor(0.5 * map.columns() + x / map.pitchX() - 1e-9), (int)
                    Math.floor(0.5 * map.rows() - y / map.pitchY() - 1e-9));
        }
    }
}
