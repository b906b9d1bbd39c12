package sunbeam.app.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.app.cli.Meter.Measurement;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.PictureFile;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.text.Text;

/** Results of a run as a Markdown page with a table for each patch. Plots and all numbers are in a folder of the page's name. */
final class BenchmarkPage {
    private static final String ENDING = ".md";
    /** Height of a plot relative to its width. */
    static final double RATIO = 0.63;

    private static final String NUMBERS = "benchmark.csv";
    // Least error that is plotted, as a logarithmic axis has no 0.
    private static final double LEAST = 1e-9;

    private final List<Section> sections = new ArrayList<>();
    private final String introduction;

    /** Plot of a patch's rows, and the end of its file's name; null if nothing is to draw. */
    private record Section(String text, List<Measurement> rows, Plot plot, String name) {}

    /** Refuses, before anything is measured, a picture that the plots of so many patches would not fit into. */
    static void requireRoom(Path page, int patches, PageOptions options) {
        if (Ending.PICTURE.isOf(page)) {
            int height = (int) (RATIO * options.pixels());
            PictureFile.requireSize(page, options.pixels(), (long) patches * height, options.width());
        }
    }

    static void checkWritable(Path page, Overwrite overwrite) {
        if (Ending.PICTURE.isOf(page)) {
            numbered(page, overwrite).checkWritable();
            return;
        }
        String name = String.valueOf(page.getFileName());
        if (!name.endsWith(ENDING) || name.length() == ENDING.length()) {
            throw new UsageException(
                    "--output " + page + " is no page and no picture; give it the ending .md, .pdf, .svg or .png");
        }
        AtomicFile.checkWritable(page, overwrite);
        OutputFolder.check(folder(page));
    }

    /** Returns a picture and its numbers. */
    private static FileGroup numbered(Path picture, Overwrite overwrite) {
        return FileGroup.named(picture, List.of("." + Ending.of(picture), ".csv"), overwrite);
    }

    private static Path folder(Path page) {
        String name = page.getFileName().toString();
        return page.resolveSibling(name.substring(0, name.length() - ENDING.length()));
    }

    BenchmarkPage(String renderer, String light, int size, int views) {
        introduction = Text.format(
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
    }

    String introduction() {
        return introduction;
    }

    List<Map<String, Object>> numbers() {
        return sections.stream()
                .flatMap(section -> section.rows().stream())
                .map(Measurement::fields)
                .toList();
    }

    /** Returns the section's text; the first row is that of the thesis's shader. */
    String addMethods(List<Measurement> rows, List<String> remarks, int width) {
        List<Measurement> drawn = rows.stream()
                .filter(row -> Double.isFinite(row.errors().median()))
                .toList();
        return add(rows, rows, remarks, drawn.isEmpty() ? null : plot(drawn, width), "methods");
    }

    String addGrowth(List<Measurement> rows, Plot plot) {
        return add(rows, List.of(), List.of(), plot, "complexity");
    }

    private String add(
            List<Measurement> rows, List<Measurement> explained, List<String> remarks, Plot plot, String name) {
        Measurement thesis = rows.get(0);
        StringBuilder text = new StringBuilder(Text.format("%n## %s%n%n", thesis.patch()));
        text.append(table(rows.stream().map(row -> cells(row, thesis)).toList()));
        text.append(Text.format("%n%d covered pixels, wall clock around glFinish.%n%n", thesis.pixels()));
        explained.forEach(row -> text.append("- " + row.method() + ": " + row.plan() + "\n"));
        remarks.forEach(remark -> text.append("\n" + remark + ".\n"));
        sections.add(new Section(text.toString(), rows, plot, name));
        return text.toString();
    }

    private static Map<String, String> cells(Measurement row, Measurement thesis) {
        ErrorStatistics errors = row.errors();
        Map<String, String> cells = new LinkedHashMap<>();
        cells.put("method", row.method());
        cells.put("median", error(errors.median()));
        cells.put("95 %", error(errors.percentile95()));
        cells.put("views", Integer.toString(errors.count()));
        double time = 1e6 * row.secondsPerPixel();
        cells.put("per pixel", time < 1 ? Math.round(1e3 * time) + " ns" : figures(time) + " us");
        cells.put("times faster", figures(thesis.secondsPerPixel() / row.secondsPerPixel()));
        cells.put("making / s", figures(row.makingSeconds()));
        cells.put("MB", figures(row.bytes() * 1e-6));
        return cells;
    }

    /** Returns a Markdown table whose columns are aligned in a terminal, too. */
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

    /** Formats three digits, without an exponent unless the number is tiny. */
    private static String figures(double value) {
        String pattern = value >= 1000 || value == Math.rint(value) ? "%.0f" : "%.3g";
        return Double.isNaN(value) ? "" : Text.format(pattern, value);
    }

    /** Writes the page, its plots and numbers; returns their files, the page first. */
    List<Path> write(Path page, Overwrite overwrite, PageOptions options) {
        if (Ending.PICTURE.isOf(page)) {
            Drawing[] plots = sections.stream()
                    .filter(section -> section.plot() != null)
                    .map(section -> section.plot().draw())
                    .toArray(Drawing[]::new);
            UsageException.throwIf(
                    plots.length == 0,
                    "--output " + page + ": nothing to plot without errors; give --samples, or a page .md");
            Drawing drawing = Drawing.column(0, plots);
            Map<String, String> text = Map.of("Title", "Error and time");
            return FileCommand.write(page, overwrite, drawing, options.width(), text, Optional.of(csv()));
        }
        List<Path> written = new ArrayList<>();
        Path folder = folder(page);
        OutputFolder.create(folder);
        StringBuilder text = new StringBuilder(introduction);
        for (Section section : sections) {
            text.append(section.text());
            if (section.plot() != null) {
                String file = section.rows().get(0).patch() + "-" + section.name() + ".png";
                written.add(FileCommand.write(
                                folder.resolve(file),
                                overwrite,
                                section.plot().draw(),
                                options.width(),
                                Map.of("Title", section.name()),
                                Optional.empty())
                        .get(0));
                text.append(Text.format("%n![%s](%s/%s)%n", section.name(), folder.getFileName(), file));
            }
        }
        written.add(AtomicFile.write(folder.resolve(NUMBERS), overwrite, csv()));
        text.append(Text.format("%nAll numbers: [%s](%s/%s).%n", NUMBERS, folder.getFileName(), NUMBERS));
        written.add(0, AtomicFile.write(page, overwrite, StreamContent.of(text)));
        return written;
    }

    private StreamContent csv() {
        return StreamContent.of(CsvWriter.text(numbers()));
    }

    private static Plot plot(List<Measurement> rows, int width) {
        String patch = rows.get(0).patch();
        Axis time = Axis.logarithmic("time per pixel / us");
        Axis error = Axis.logarithmic("relative error of XYZ (median)");
        Plot plot = new Plot(new Plot.Frame(patch + ": error over time", time, error, width, (int) (RATIO * width)));
        for (Measurement row : rows) {
            double[] x = {1e6 * row.secondsPerPixel()};
            double[] y = {Math.max(LEAST, row.errors().median())};
            if (row.method().equals(BenchmarkCommand.THESIS)) {
                plot.rings(row.method(), x, y);
            } else {
                plot.points(row.method(), x, y);
            }
        }
        return plot;
    }
}
