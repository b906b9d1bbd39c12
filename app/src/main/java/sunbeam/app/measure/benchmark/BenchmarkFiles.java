package sunbeam.app.measure.benchmark;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;
import sunbeam.app.terminal.UsageException;

/** A page, and beside it a folder of the same name with plots (PNG) and all numbers (CSV). */
final class BenchmarkFiles {
    private static final String ENDING = ".md";
    private static final String NUMBERS = "benchmark.csv";
    private static final int WIDTH = 900;
    private static final int HEIGHT = 480;
    // Logarithms have no place for an error of 0, and what has grown beyond all bounds is drawn at the top.
    private static final double LEAST = 1e-9;
    private static final double MOST = 1e6;

    private final Path page;
    private final Path folder;
    private final Overwrite overwrite;
    private final StringBuilder text = new StringBuilder();
    private final List<String> rows = new ArrayList<>();

    /**
     * Refuses what could not be written, before anything is measured.
     *
     * @throws UsageException when the page has not the ending .md
     * @throws sunbeam.app.files.output.OutputException when one of the files is there and must not be replaced
     */
    BenchmarkFiles(Path page, Overwrite overwrite) {
        String name = String.valueOf(page.getFileName());
        if (!name.endsWith(ENDING) || name.length() == ENDING.length()) {
            throw new UsageException("--output " + page + " is no page; give it the ending .md");
        }
        this.page = page;
        this.folder = page.resolveSibling(name.substring(0, name.length() - ENDING.length()));
        this.overwrite = overwrite;
        AtomicFile.checkWritable(page, overwrite);
        OutputFolder.check(folder);
    }

    /** Adds words. */
    void add(String words) {
        text.append(words);
    }

    /** Adds what the methods take on a patch, with a plot of error over time. */
    void addMethods(String words, List<Measured> measured) {
        text.append(words);
        measured.forEach(row -> rows.add(row("", "", row)));
        String patch = measured.get(0).patch();
        Plot plot = plot(patch + ": error over time", "time per pixel / us", "relative error of XYZ (median)");
        List<Measured> drawn = measured.stream()
                .filter(row -> row.errors().isPresent())
                .filter(row -> row.errors().get().relative().count() > 0)
                .toList();
        for (Measured row : drawn) {
            double[] x = {row.microsecondsPerPixel()};
            double[] y = {
                Math.max(LEAST, Math.min(MOST, row.errors().get().relative().median()))
            };
            if (row.method().equals(Contender.THESIS.name())) {
                plot.rings(row.method(), x, y);
            } else {
                plot.points(row.method(), x, y);
            }
        }
        if (!drawn.isEmpty()) {
            write(plot, patch + "-methods", "error over time");
        }
    }

    /** Adds how cost grows, with a plot for each axis. */
    void addGrowth(String words, List<Growth> growths) {
        text.append(words);
        for (Growth growth : growths) {
            growth.points()
                    .forEach(point -> rows.add(row(growth.axis(), Double.toString(point.x()), point.measured())));
            if (growth.points().isEmpty()) {
                continue;
            }
            Plot plot = plot("Cost over " + growth.key(), growth.axis(), "time / s");
            growth.byMethod().forEach((method, points) -> {
                double[] x = points.stream().mapToDouble(Growth.Point::x).toArray();
                plot.lineWithPoints(method + ": a frame", x, of(points, Measured::frameSeconds));
                plot.lineWithPoints(method + ": making", x, of(points, Measured::makingSeconds));
            });
            write(plot, growth.key(), "cost over " + growth.key());
        }
    }

    /** Writes the page and the numbers. */
    Path write() {
        write(folder.resolve(NUMBERS), String.join("", rows));
        text.append(
                String.format(Locale.ROOT, "%nAll numbers: [%s](%s/%s).%n", NUMBERS, folder.getFileName(), NUMBERS));
        write(page, text.toString());
        return page;
    }

    private void write(Path file, String content) {
        OutputFolder.create(folder);
        byte[] bytes = content.getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(file, overwrite, stream -> stream.write(bytes));
    }

    private void write(Plot plot, String stem, String title) {
        OutputFolder.create(folder);
        plot.write(folder.resolve(stem + ".png"), overwrite, Map.of("Title", title));
        text.append(String.format(Locale.ROOT, "%n![%s](%s/%s.png)%n", title, folder.getFileName(), stem));
    }

    private static Plot plot(String title, String x, String y) {
        return new Plot(new Frame(title, Axis.logarithmic(x), Axis.logarithmic(y), WIDTH, HEIGHT));
    }

    /** A row of the table of numbers, below the header where it is the first. */
    private String row(String axis, String value, Measured measured) {
        Map<String, Object> fields = measured.fields();
        String header = rows.isEmpty() ? "varied,value," + String.join(",", fields.keySet()) + "\n" : "";
        return fields.values().stream()
                .map(field -> quoted(field.toString()))
                .collect(Collectors.joining(",", header + quoted(axis) + "," + value + ",", "\n"));
    }

    private static String quoted(String field) {
        return field.matches("[^\",\\r\\n]*") ? field : '"' + field.replace("\"", "\"\"") + '"';
    }

    private static double[] of(List<Growth.Point> points, ToDoubleFunction<Measured> value) {
        return points.stream()
                .map(Growth.Point::measured)
                .mapToDouble(value)
                .map(seconds -> Math.max(LEAST, seconds))
                .toArray();
    }
}
