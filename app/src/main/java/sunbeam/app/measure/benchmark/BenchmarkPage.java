package sunbeam.app.measure.benchmark;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.measure.errors.Comparison;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;

/** A run as a page, part by part: Markdown that a terminal shows, too; as files with plots (PNG) and all numbers (CSV). */
final class BenchmarkPage {
    private static final String ENDING = ".md";
    private static final String NUMBERS = "benchmark.csv";
    // A logarithm has no place for an error of 0.
    private static final double LEAST = 1e-9;

    private final List<Section> sections = new ArrayList<>();
    private final Map<String, List<Map<String, Object>>> tables = new LinkedHashMap<>();

    /** @param drawings that follow the text */
    private record Section(String text, List<Drawing> drawings) {}

    /** A plot with its title in the file and its caption in the page. */
    private record Drawing(String file, String title, String caption, Supplier<Plot> plot) {}

    private String add(String text, List<Drawing> drawings) {
        sections.add(new Section(text, drawings));
        return text;
    }

    /**
     * Tells early what could not be written.
     *
     * @throws UsageException when the page has not the ending .md
     * @throws sunbeam.app.files.output.OutputException when one of the files is there and must not be replaced
     */
    static void checkWritable(Path page, Overwrite overwrite) {
        String name = String.valueOf(page.getFileName());
        if (!name.endsWith(ENDING) || name.length() == ENDING.length()) {
            throw new UsageException("--output " + page + " is no page; give it the ending .md");
        }
        AtomicFile.checkWritable(page, overwrite);
        OutputFolder.check(folder(page));
    }

    private static Path folder(Path page) {
        String name = page.getFileName().toString();
        return page.resolveSibling(name.substring(0, name.length() - ENDING.length()));
    }

    String introduce(String renderer, String light, int size, int views) {
        String text = Text.format(
                """
                # Error and time

                `sunbeam benchmark`, %s, %d processors.

                - Maps of %d x %d pixels, light at %s.
                - Time: median of %d frames after one for warming up; of short frames as many as take %.1f s, of slow ones those that
                  end within %.0f s. On a shared machine only ratios mean something: to the thesis's shader (`full --preset thesis`).
                - Making: from the heights to what the shader reads, on the card, nothing from the cache.
                - Error: of X, Y, Z, relative to the largest of them, against `reference` under the method's own window and average,
                  at up to %d random views of that light, half of them aimed at orders, of power above %.0e.
                """,
                renderer,
                Runtime.getRuntime().availableProcessors(),
                size,
                size,
                light,
                Meter.FRAMES,
                Meter.LEAST_SECONDS,
                Meter.MOST_SECONDS,
                views,
                Comparison.FLOOR);
        tables.put(NUMBERS, new ArrayList<>());
        return add(text, List.of());
    }

    /**
     * @param remarks what is not measured, and why
     */
    String add(List<Measured> rows, List<String> remarks) {
        Measured thesis = rows.get(0);
        StringBuilder text = new StringBuilder(Text.format("%n## %s%n%n", thesis.patch()));
        text.append(table(rows.stream().map(row -> cells(row, thesis)).toList()));
        text.append(Text.format(
                "%n%d covered pixels, wall clock around glFinish.%n%n",
                thesis.timing().pixels()));
        rows.forEach(row -> text.append("- " + row.method() + ": " + row.plan() + "\n"));
        remarks.forEach(remark -> text.append("\n" + remark + ".\n"));
        rows.forEach(row -> tables.get(NUMBERS).add(row.fields()));
        List<Measured> drawn = rows.stream().filter(BenchmarkPage::isDrawn).toList();
        String file = thesis.patch() + "-methods.png";
        String title = "error over time";
        return add(
                text.toString(),
                drawn.isEmpty()
                        ? List.of()
                        : List.of(new Drawing(file, title, title, () -> plot(thesis.patch(), drawn))));
    }

    String add(List<Resolutions.Point> points, String light) {
        List<Map<String, String>> rows = new ArrayList<>();
        for (Resolutions.Point point : points) {
            Map<String, String> cells = new LinkedHashMap<>();
            cells.put("patch", point.patch());
            cells.put("samples", Integer.toString(point.samples()));
            cells.put("distance / nm", figures(point.pitch() * 1e9));
            cells.put("median", error(point.errors().median()));
            cells.put("95 %", error(point.errors().percentile95()));
            rows.add(cells);
        }
        String text = Text.format(
                "# Error over the scan's resolution%n%n`sunbeam benchmark --resolutions`: X, Y, Z by `full` with fewer samples against all"
                        + " of them, at %d random views of light at %s, half of them aimed at orders.%n%n",
                Resolutions.VIEWS, light);
        tables.put(NUMBERS, points.stream().map(Resolutions.Point::fields).toList());
        Supplier<Plot> plot = () -> Resolutions.plot(points);
        return add(
                text + table(rows),
                List.of(new Drawing("resolutions.png", "resolutions", "error over resolution", plot)));
    }

    String add(Growth measured) {
        StringBuilder text = new StringBuilder(Text.format(
                "%n## How cost grows%n%n`full` and `table` at tolerance 1e-2 on %s, half of the coherence length; pixels along a side of the map,"
                        + " samples along a side of the patch, relief or coherence length times a factor.%n%n",
                measured.patch()));
        text.append(
                table(measured.points().stream().map(BenchmarkPage::growthCells).toList()));
        measured.remarks().forEach(remark -> text.append("\nNot measured: " + remark + ".\n"));
        tables.put(
                "growth.csv",
                measured.points().stream().map(Growth.Point::fields).toList());
        List<Drawing> drawings = new ArrayList<>();
        measured.points().stream()
                .collect(Collectors.groupingBy(
                        point -> point.measured().method(), LinkedHashMap::new, Collectors.toList()))
                .forEach((method, points) -> drawings.add(new Drawing(
                        "growth-" + method + ".png", "growth", "how cost grows", () -> growthPlot(method, points))));
        return add(text.toString(), drawings);
    }

    private static Map<String, String> growthCells(Growth.Point point) {
        Map<String, String> cells = new LinkedHashMap<>();
        cells.put("varied", point.axis());
        cells.put("factor", figures(point.factor()));
        cells.put("method", point.measured().method());
        cells.put("making / s", figures(point.measured().makingSeconds()));
        cells.put("frame / s", figures(point.measured().frameSeconds()));
        cells.put("per pixel", perPixel(point.measured().microsecondsPerPixel()));
        cells.put("MB", figures(point.measured().bytes() * 1e-6));
        return cells;
    }

    private static String perPixel(double microseconds) {
        return microseconds < 1 ? Math.round(1e3 * microseconds) + " ns" : figures(microseconds) + " us";
    }

    private static Map<String, String> cells(Measured row, Measured thesis) {
        ErrorStatistics errors = row.errors();
        Map<String, String> cells = new LinkedHashMap<>();
        cells.put("method", row.method());
        cells.put("median", error(errors.median()));
        cells.put("95 %", error(errors.percentile95()));
        cells.put("views", Integer.toString(errors.count()));
        cells.put("per pixel", perPixel(row.microsecondsPerPixel()));
        cells.put("times faster", figures(row.timesFaster(thesis)));
        cells.put("making / s", figures(row.makingSeconds()));
        cells.put("MB", figures(row.bytes() * 1e-6));
        return cells;
    }

    /** Markdown whose columns stand below each other in a terminal, too. */
    private static String table(List<Map<String, String>> rows) {
        List<List<String>> lines = new ArrayList<>();
        lines.add(List.copyOf(rows.get(0).keySet()));
        rows.forEach(row -> lines.add(List.copyOf(row.values())));
        int[] widths = IntStream.range(0, lines.get(0).size())
                .map(column -> lines.stream()
                        .mapToInt(line -> line.get(column).length())
                        .max()
                        .orElseThrow())
                .toArray();
        lines.add(1, IntStream.of(widths).mapToObj("-"::repeat).toList());
        StringBuilder text = new StringBuilder();
        for (List<String> line : lines) {
            for (int column = 0; column < widths.length; column++) {
                text.append(Text.format("| %-" + widths[column] + "s ", line.get(column)));
            }
            text.append("|\n");
        }
        return text.toString();
    }

    private static String error(double value) {
        return Double.isNaN(value) ? "" : Text.format("%.1e", value);
    }

    /** Three figures, without an exponent where they are not tiny. */
    private static String figures(double value) {
        if (Double.isNaN(value)) {
            return "";
        }
        return Text.format(value >= 1000 || value == Math.rint(value) ? "%.0f" : "%.3g", value);
    }

    /** Writes the page, and into a folder of its name a plot for each patch and all numbers. */
    void write(Path page, Overwrite overwrite) {
        Path folder = folder(page);
        OutputFolder.create(folder);
        StringBuilder text = new StringBuilder();
        for (Section section : sections) {
            text.append(section.text());
            for (Drawing drawing : section.drawings()) {
                drawing.plot().get().write(folder.resolve(drawing.file()), overwrite, Map.of("Title", drawing.title()));
                text.append(Text.format("%n![%s](%s/%s)%n", drawing.caption(), folder.getFileName(), drawing.file()));
            }
        }
        tables.forEach((file, rows) ->
                AtomicFile.write(folder.resolve(file), overwrite, AtomicFile.StreamContent.of(CsvWriter.text(rows))));
        text.append(Text.format("%nAll numbers: [%s](%s/%s).%n", NUMBERS, folder.getFileName(), NUMBERS));
        AtomicFile.write(page, overwrite, AtomicFile.StreamContent.of(text));
    }

    private static Plot growthPlot(String method, List<Growth.Point> points) {
        Axis factor = Axis.logarithmic("factor");
        Axis time = Axis.logarithmic("making and a frame / s");
        Plot plot = new Plot(new Plot.Frame("How the cost of " + method + " grows", factor, time, 900, 480));
        Map<String, List<Growth.Point>> series = points.stream()
                .collect(Collectors.groupingBy(Growth.Point::axis, LinkedHashMap::new, Collectors.toList()));
        series.forEach((name, some) -> plot.line(
                name,
                some.stream().mapToDouble(Growth.Point::factor).toArray(),
                some.stream()
                        .mapToDouble(point -> point.measured().makingSeconds()
                                + point.measured().frameSeconds())
                        .toArray()));
        return plot;
    }

    private static boolean isDrawn(Measured row) {
        return row.errors().count() > 0 && Double.isFinite(row.errors().median());
    }

    private static Plot plot(String patch, List<Measured> rows) {
        Axis time = Axis.logarithmic("time per pixel / us");
        Axis error = Axis.logarithmic("relative error of XYZ (median)");
        Plot plot = new Plot(new Plot.Frame(patch + ": error over time", time, error, 900, 480));
        for (Measured row : rows) {
            double[] x = {row.microsecondsPerPixel()};
            double[] y = {Math.max(LEAST, row.errors().median())};
            if (row.method().equals(Contender.THESIS.name())) {
                plot.rings(row.method(), x, y);
            } else {
                plot.points(row.method(), x, y);
            }
        }
        return plot;
    }
}
