package sunbeam.app.cli.figures;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.PictureFile;
import sunbeam.app.files.plot.Plot;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.Illuminant;

/** Plot that no command draws: of formulas of the thesis, or of the results of a figure's other pictures. */
enum FigurePlot {
    @JsonProperty("wavenumber")
    WAVENUMBER,
    @JsonProperty("color matching")
    COLOR_MATCHING,
    @JsonProperty("sinc")
    SINC,
    @JsonProperty("slits")
    SLITS,
    @JsonProperty("responses")
    RESPONSES,
    @JsonProperty("errors")
    ERRORS;

    private static final int WIDTH = Drawing.COLUMN;
    private static final int HEIGHT = 800;
    private static final double EQUAL_POWER = 100;

    /** Draws the plot, and writes its numbers, if it has any, as JSON; a plot of fewer than two results is left out. */
    void draw(Figure.Drawing drawing, List<Figure.Drawing> all) {
        String ending = this == ERRORS ? ".npy" : ".csv";
        List<Figure.Drawing> results = all.stream()
                .filter(other -> other.patch().equals(drawing.patch())
                        && Files.exists(other.file())
                        && Files.isRegularFile(other.beside(ending)))
                .toList();
        if ((this == ERRORS || this == RESPONSES) && results.size() < 2) {
            return;
        }
        Map<String, Double> numbers = new LinkedHashMap<>();
        Plot plot = switch (this) {
            case WAVENUMBER -> wavenumber(numbers);
            case COLOR_MATCHING -> colorMatching(numbers);
            case SINC -> sinc(numbers);
            case SLITS -> slits(numbers);
            case RESPONSES -> responses(results);
            case ERRORS -> errors(results);
        };
        Map<String, String> text = Map.of("Title", drawing.picture().label());
        AtomicFile.write(
                drawing.file(),
                Overwrite.REPLACE,
                PictureFile.of(drawing.file(), plot.draw(), Drawing.STANDARD_WIDTH, text));
        if (!numbers.isEmpty()) {
            String report = JsonOption.text(JsonOption.withCommand("figures", Map.of("numbers", numbers)));
            AtomicFile.write(drawing.beside(".json"), Overwrite.REPLACE, StreamContent.of(report));
        }
    }

    /** Plots k = 2 pi / lambda of visible light. */
    private static Plot wavenumber(Map<String, Double> numbers) {
        double[] nanometers = IntStream.rangeClosed(CieTable.FIRST_NANOMETER, CieTable.LAST_NANOMETER)
                .asDoubleStream()
                .toArray();
        double[] perMicrometer = map(nanometers, nanometer -> 2000 * Math.PI / nanometer);
        numbers.put("ratio", perMicrometer[0] / perMicrometer[perMicrometer.length - 1]);
        return Plot.linear("Wavenumber of light", "wavelength / nm", "k / (rad / µm)", WIDTH, HEIGHT)
                .line("k = 2 pi / lambda", nanometers, perMicrometer);
    }

    /** Plots the observer's functions and measures the largest relative error of their integrals in the thesis's steps of 5 nm. */
    private static Plot colorMatching(Map<String, Double> numbers) {
        CieTable table = CieTable.of(CieTable.Observer.CIE1931, Illuminant.of("E"));
        Plot plot = Plot.linear("CIE 1931, 2 degrees", "wavelength / nm", "color matching function", WIDTH, HEIGHT);
        double[] nanometers = IntStream.rangeClosed(CieTable.FIRST_NANOMETER, CieTable.LAST_NANOMETER)
                .asDoubleStream()
                .toArray();
        // Blue, green and red, in the order in which the functions peak.
        for (int channel : new int[] {2, 1, 0}) {
            int c = channel;
            double[] values = map(nanometers, nanometer -> table.at(nanometer * 1e-9, c) / EQUAL_POWER);
            double fine = Arrays.stream(values).sum();
            double coarse = IntStream.range(0, values.length)
                    .filter(i -> i % 5 == 0)
                    .mapToDouble(i -> 5 * values[i])
                    .sum();
            numbers.merge("loss", Math.abs(coarse / fine - 1), Math::max);
            plot.line("xyz".substring(c, c + 1), nanometers, values, new int[] {1, 2, 0}[c]);
        }
        return plot;
    }

    /** Reconstructs a random signal, a sum of 30 waves below the Nyquist frequency, from 100 samples by the sum of sincs over them. */
    private static Plot sinc(Map<String, Double> numbers) {
        Random random = new Random(1);
        double[] cosines = random.doubles(30, -1, 1).toArray();
        double[] sines = random.doubles(30, -1, 1).toArray();
        DoubleUnaryOperator signal = t -> IntStream.range(0, 30)
                .mapToDouble(
                        k -> cosines[k] * Math.cos(Math.PI * k * t / 50) + sines[k] * Math.sin(Math.PI * k * t / 50))
                .sum();
        double[] samples =
                IntStream.range(0, 100).mapToDouble(signal::applyAsDouble).toArray();
        DoubleUnaryOperator reconstructed = t -> IntStream.range(0, 100)
                .mapToDouble(n -> samples[n] * (t == n ? 1 : Math.sin(Math.PI * (t - n)) / (Math.PI * (t - n))))
                .sum();
        double[] times = IntStream.rangeClosed(0, 990).mapToDouble(i -> 0.1 * i).toArray();
        double[] exact = map(times, signal);
        double[] ours = map(times, reconstructed);
        double squares = IntStream.range(0, times.length)
                .mapToDouble(i -> Math.pow(ours[i] - exact[i], 2))
                .sum();
        double power = Arrays.stream(exact).map(value -> value * value).sum();
        numbers.put("error", Math.sqrt(squares / power));
        return Plot.linear("Sinc interpolation of 100 samples", "t / step", "s(t)", WIDTH, HEIGHT)
                .line("signal", times, exact)
                .line("sum of sincs", times, ours)
                .points("samples", IntStream.range(0, 100).asDoubleStream().toArray(), samples);
    }

    /**
     * Plots the thesis's slits, 30 um wide and 150 um apart, in light of 500 nm on a screen in 0.5 m: the pattern of a single slit times
     * the power of the sum of the slits' waves, with exact ways; the thin line is for parallel rays.
     */
    private static Plot slits(Map<String, Double> numbers) {
        double distance = 0.5;
        double wavelength = 500e-9;
        double[] millimeters =
                IntStream.rangeClosed(-500, 500).mapToDouble(i -> 0.01 * i).toArray();
        String title = "Slits 30 um wide, 150 um apart, 500 nm, screen at 0.5 m";
        Plot plot = Plot.linear(title, "place on the screen / mm", "relative intensity", WIDTH, HEIGHT);
        for (int count : new int[] {1, 2, 3, 7}) {
            for (boolean parallel : count == 7 ? new boolean[] {false, true} : new boolean[] {false}) {
                double[] intensities = map(millimeters, millimeter -> {
                    double x = 1e-3 * millimeter;
                    double real = 0;
                    double imaginary = 0;
                    for (int slit = 0; slit < count; slit++) {
                        double at = 150e-6 * (slit - 0.5 * (count - 1));
                        double way = parallel ? -at * Math.sin(Math.atan(x / distance)) : Math.hypot(distance, x - at);
                        real += Math.cos(2 * Math.PI * way / wavelength);
                        imaginary += Math.sin(2 * Math.PI * way / wavelength);
                    }
                    double turns = Math.PI * 30e-6 * Math.sin(Math.atan(x / distance)) / wavelength;
                    double slit = turns == 0 ? 1 : Math.sin(turns) / turns;
                    return slit * slit * (real * real + imaginary * imaginary);
                });
                double largest = Arrays.stream(intensities).max().orElseThrow();
                double[] relative = map(intensities, intensity -> intensity / largest);
                String name = parallel ? "7, parallel rays" : count + (count == 1 ? " slit" : " slits");
                double width = new Measure.Response(millimeters, relative).width();
                numbers.put(parallel ? "parallel_7" : "width_" + count, width);
                plot = parallel ? plot.outline(name, millimeters, relative) : plot.line(name, millimeters, relative);
            }
        }
        return plot;
    }

    private static Plot responses(List<Figure.Drawing> results) {
        Plot plot =
                Plot.linear("Light of 500 nm", "angle to the viewer / degrees", "relative intensity", WIDTH, HEIGHT);
        for (Figure.Drawing drawing : results) {
            Measure.Response response = Measure.Response.read(drawing);
            plot.line(drawing.picture().label(), response.angles(), response.values());
        }
        return plot;
    }

    /** Plots the error over the number of terms, by which the maps are named, against the first map, which has the most. */
    private static Plot errors(List<Figure.Drawing> results) {
        List<Figure.Drawing> compared = results.subList(1, results.size());
        double[] terms = new double[compared.size()];
        double[] values = new double[compared.size()];
        Arrays.setAll(terms, i -> Double.parseDouble(compared.get(i).picture().name()));
        Arrays.setAll(values, i -> Measure.error(compared.get(i), results.get(0)));
        Plot.Axis errors = Plot.Axis.logarithmic("error of the light");
        return new Plot(new Plot.Frame("Taylor terms", Plot.Axis.linear("terms"), errors, WIDTH, HEIGHT))
                .points("error", terms, values);
    }

    private static double[] map(double[] values, DoubleUnaryOperator function) {
        return Arrays.stream(values).map(function).toArray();
    }
}
