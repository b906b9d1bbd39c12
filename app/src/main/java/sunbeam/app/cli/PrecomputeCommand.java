package sunbeam.app.cli;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.PlotStyle;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;
import sunbeam.precompute.spectrum.ComplexVector;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.text.Text;

/** Command {@code sunbeam precompute}: writes the Fourier tables of a patch for other programs. */
@Command(
        name = "precompute",
        header = "Write the Fourier tables of a patch as HDF5.",
        description = "Write the Fourier tables of a patch to one HDF5 file: the DFT of every term T_n(h) of the"
                + " expansion of exp(i k w h), complex float32, cropped to what any pair of directions can see. The"
                + " file says what its numbers mean; see docs/conventions.md.",
        footer = {"  sunbeam precompute blaze --output blaze.h5"})
public final class PrecomputeCommand extends FileCommand {
    private static final int MOST_POWER = 99;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private final MethodOptions methodOptions = MethodOptions.of(FullMethod.TYPE);

    @Option(names = "--output", paramLabel = "FILE.h5", description = "The file. Default: the patch's name.")
    private Path output;

    @Option(
            names = "--picture",
            paramLabel = "FILE.png",
            description = "Write no table, but draw the DFT of powers (i h)^n of the heights, in micrometers above the"
                    + " lowest: real parts red, imaginary parts green; and their extreme values over n.")
    private Path picture;

    @Option(
            names = "--powers",
            paramLabel = "N",
            split = ",",
            defaultValue = "0,1,4,10,20",
            description =
                    "Powers of --picture, 0 to 99, ascending. Of one alone there is no plot. Default: ${DEFAULT-VALUE}.")
    private List<Integer> powers;

    @Override
    public Integer call() {
        Ending.HDF5.require("--output", output);
        Choices choices = methodOptions.choices();
        return choices.located(() -> picture == null ? write(choices) : drawPowers(choices));
    }

    private int drawPowers(Choices choices) {
        Ending.PNG.require("--picture", picture);
        for (int i = 0; i < powers.size(); i++) {
            UsageException.throwIf(
                    powers.get(i) < 0 || powers.get(i) > MOST_POWER || (i > 0 && powers.get(i) <= powers.get(i - 1)),
                    "--powers " + powers.get(i) + ": give ascending numbers from 0 to " + MOST_POWER);
        }
        AtomicFile.checkWritable(picture, overwrite());
        Patch patch = patchOptions.load(choices);
        double[][] extremes = new double[4][powers.get(powers.size() - 1) + 1];
        FourierImages images = new FourierImages(patch.heights(), powers, extremes);
        BufferedImage image = images.draw();
        double[] largest = new double[extremes[0].length];
        Arrays.setAll(largest, images::largest);
        Map<String, String> text = new TreeMap<>(Map.of(
                "Title", "Fourier images of " + patch.name(),
                "Patch", patch.source(),
                "Extremes", Arrays.toString(largest)));
        Path written = PngWriter.write(picture, overwrite(), image, text);
        json.print(out(picture), new TreeMap<>(Map.of("patch", patch.name(), "powers", powers)), List.of(written));
        return ExitCode.OK.code();
    }

    private int write(Choices choices) {
        FullMethod.of(choices);
        AtomicFile.checkWritable(output, overwrite());
        DiffractionSetup setup =
                new DiffractionSetup(patchOptions.load(choices, environment(), err()), environment(), err());
        FullMethod method = FullMethod.of(setup.limitToScan(choices, err()));
        Path file = writable(output, setup.patch().name() + ".h5");
        SpectrumPlan plan = method.tablePlan(setup.surface(), VisibleRange.all());
        methodOptions.explain(plan, err());
        long start = System.nanoTime();
        FourierTable table = setup.fourier(plan);
        double seconds = (System.nanoTime() - start) * 1e-9;
        Surface surface = setup.surface();
        Path written = AtomicFile.writeFile(
                file, overwrite(output), path -> table.write(path, surface.name(), surface.digest()));
        PrintWriter out = out(file);
        String kind = ValueKind.name(table.expansion().kind());
        int columns = table.bandX().count();
        int rows = table.bandY().count();
        String size = Text.format("%.1f MB, made in %.2f s", table.bytes() * 1e-6, seconds);
        json.text(out).println(table.terms() + " " + kind + " terms of " + columns + " x " + rows + " bins, " + size);
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("patch", setup.patch().name());
        report.put("kind", kind);
        report.put("terms", table.terms());
        report.put("columns", columns);
        report.put("rows", rows);
        report.put("bytes", table.bytes());
        report.put("making_s", seconds);
        json.print(out, report, List.of(written));
        return ExitCode.OK.code();
    }

    /**
     * Figure 3.1 of the thesis: inverse DFT of powers (i h)^n of the heights h, in micrometers above the lowest. Red shows real parts and green
     * imaginary parts, logarithmically: mid-gray is 0, and the extremes are 0 and 255. A plot shows the magnitudes of these extremes over n.
     *
     * @param powers exponents n, ascending; with more than one, a plot of the extremes for n from 0 to the last is added
     * @param extremes result: least and greatest real, least and greatest imaginary part of each power from 0 on; 0 for powers left out
     */
    private record FourierImages(HeightMap map, List<Integer> powers, double[][] extremes) {
        private static final int SIDE = (Drawing.COLUMN - 24) / 3;
        private static final int CAPTION = 48;
        private static final int GAP = 12;
        private static final int PLOT_HEIGHT = 800;
        private static final int ACROSS = 3;
        private static final double MICROMETERS = 1e6;
        // Smallest magnitude that differs from 0 in an image, relative to the largest real or imaginary part.
        private static final double SPAN = 1e-4;
        // Magnitude below which an extreme is a rounding error, relative to the largest one of its power.
        private static final double ROUNDING = 1e-12;
        private static final int RED = 1;
        private static final int GREEN = 2;

        BufferedImage draw() {
            int rows = (powers.size() + ACROSS - 1) / ACROSS;
            Sheet sheet = new Sheet(Drawing.COLUMN).part(rows * (SIDE + CAPTION), this::draw);
            return (powers.size() > 1 ? sheet.part(PLOT_HEIGHT, graphics -> plot().drawAt(graphics, 0, 0)) : sheet)
                    .draw()
                    .rasterize();
        }

        /** Returns the largest magnitude of a real or imaginary part of a power. */
        double largest(int n) {
            return Arrays.stream(extremes)
                    .mapToDouble(values -> Math.abs(values[n]))
                    .max()
                    .orElseThrow();
        }

        private void draw(Graphics2D graphics) {
            boolean plotted = powers.size() > 1;
            int last = extremes[0].length - 1;
            for (int n = plotted ? 0 : last; n <= last; n++) {
                ComplexVector bins = transformed(n);
                extremes[0][n] = StatUtils.min(bins.real());
                extremes[1][n] = StatUtils.max(bins.real());
                extremes[2][n] = StatUtils.min(bins.imaginary());
                extremes[3][n] = StatUtils.max(bins.imaginary());
                int number = powers.indexOf(n);
                if (number >= 0) {
                    int x = number % ACROSS * (SIDE + GAP);
                    int y = number / ACROSS * (SIDE + CAPTION);
                    graphics.drawImage(image(bins, largest(n)), x, y, SIDE, SIDE, null);
                    graphics.drawString(PlotStyle.typeset("(i h)^" + n), x + 4, y + SIDE + CAPTION - 12);
                }
            }
        }

        private ComplexVector transformed(int power) {
            double lowest = map.minimum();
            // (i h)^n is real or imaginary, positive or negative, by n modulo 4.
            double sign = power % 4 < 2 ? 1 : -1;
            boolean isReal = power % 2 == 0;
            Band bandX = new Band(-(map.columns() / 2), map.columns());
            Band bandY = new Band(-(map.rows() / 2), map.rows());
            return new BandTransform2d(map.columns(), map.rows(), bandX, bandY).transform((row, real, imaginary) -> {
                for (int column = 0; column < map.columns(); column++) {
                    double value = sign * Math.pow(MICROMETERS * (map.at(column, row) - lowest), power);
                    real[column] = isReal ? value : 0;
                    imaginary[column] = isReal ? 0 : value;
                }
            });
        }

        /** Draws, for each pixel, the bin of largest magnitude in it; frequency 0 is in the middle, y points up. */
        private BufferedImage image(ComplexVector bins, double largest) {
            int width = Math.min(SIDE, map.columns());
            int height = Math.min(SIDE, map.rows());
            int[] strongest = new int[width * height];
            Arrays.fill(strongest, -1);
            for (int i = 0; i < bins.length(); i++) {
                int x = (int) ((long) (i % map.columns()) * width / map.columns());
                int y = height - 1 - (int) ((long) (i / map.columns()) * height / map.rows());
                int before = strongest[y * width + x];
                if (before < 0 || strength(bins, i) > strength(bins, before)) {
                    strongest[y * width + x] = i;
                }
            }
            BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
            for (int i = 0; i < strongest.length; i++) {
                int rgb = channel(bins.real()[strongest[i]] / largest) << 16
                        | channel(bins.imaginary()[strongest[i]] / largest) << 8;
                image.setRGB(i % width, i / width, rgb);
            }
            return image;
        }

        private static double strength(ComplexVector bins, int i) {
            return Math.hypot(bins.real()[i], bins.imaginary()[i]);
        }

        private static int channel(double value) {
            double brightness = Math.log(Math.max(1, Math.abs(value) / SPAN)) / Math.log(1 / SPAN);
            return (int) Math.round(127.5 * (1 + Math.copySign(brightness, value)));
        }

        private Drawing plot() {
            double[] exponents =
                    IntStream.range(0, extremes[0].length).asDoubleStream().toArray();
            double[][] magnitudes = Arrays.stream(extremes)
                    .map(values -> Arrays.stream(values).map(Math::abs).toArray())
                    .toArray(double[][]::new);
            for (double[] values : magnitudes) {
                Arrays.setAll(values, n -> values[n] > ROUNDING * largest(n) ? values[n] : Double.NaN);
            }
            return new Plot(new Plot.Frame(
                            "Extreme values",
                            Plot.Axis.linear("power n"),
                            Plot.Axis.logarithmic("|DFT of (i h)^n| / um^n"),
                            Drawing.COLUMN,
                            PLOT_HEIGHT))
                    .line("greatest real", exponents, magnitudes[1], RED)
                    .points("least real", exponents, magnitudes[0], RED)
                    .line("greatest imaginary", exponents, magnitudes[3], GREEN)
                    .points("least imaginary", exponents, magnitudes[2], GREEN)
                    .draw();
        }
    }
}
