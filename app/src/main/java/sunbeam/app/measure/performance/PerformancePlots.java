package sunbeam.app.measure.performance;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;
import sunbeam.app.measure.errors.ErrorStatistics;

/** The report's plots, and their numbers as CSV. */
final class PerformancePlots {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 480;
    // Logarithms have no place for an error of 0, and what has grown beyond all bounds is drawn at the top.
    private static final double LEAST = 1e-9;
    private static final double MOST = 1e6;

    private final Path folder;
    private final Overwrite overwrite;

    PerformancePlots(Path folder, Overwrite overwrite) {
        this.folder = folder;
        this.overwrite = overwrite;
    }

    /** Error over time per pixel. */
    void write(PatchFigures figures) {
        String title = figures.patch() + ": error over time";
        Plot plot = new Plot(new Frame(
                title,
                Axis.logarithmic("time per pixel / us"),
                Axis.logarithmic("relative error of XYZ (median)"),
                WIDTH,
                HEIGHT));
        List<Measured> drawn = figures.rows().stream()
                .filter(row -> row.errors().isPresent() && Double.isFinite(row.microseconds()))
                .filter(row -> row.errors().get().count() > 0)
                .toList();
        for (String family : List.of("full, tolerance", "table, coherent", "table, ensemble")) {
            List<Measured> members =
                    drawn.stream().filter(row -> row.name().startsWith(family)).toList();
            if (!members.isEmpty()) {
                plot.lineWithPoints(
                        family.replace(", tolerance", ", planned"),
                        values(members, Measured::microseconds),
                        values(members, PerformancePlots::error));
            }
        }
        drawn.stream()
                .filter(PerformancePlots::standsAlone)
                .forEach(row -> plot.points(
                        row.name().replaceFirst("look-up of ", ""),
                        new double[] {row.microseconds()},
                        new double[] {error(row)}));
        drawn.stream()
                .filter(row -> row.name().equals("full, thesis"))
                .forEach(row -> plot.rings(row.name(), new double[] {row.microseconds()}, new double[] {error(row)}));
        if (!drawn.isEmpty()) {
            plot.write(folder.resolve(PerformancePage.stem(figures) + ".png"), overwrite, Map.of("Title", title));
        }
        writeTable(figures);
    }

    private static boolean standsAlone(Measured row) {
        return !row.name().startsWith("full") && !row.name().startsWith("table");
    }

    private static double error(Measured row) {
        return Math.max(LEAST, Math.min(MOST, row.errors().orElseThrow().median()));
    }

    private void writeTable(PatchFigures figures) {
        StringBuilder text =
                new StringBuilder("method,views,XYZ median,XYZ p95,XYZ maximum,us per pixel,making s,MB\n");
        for (Measured row : figures.rows()) {
            ErrorStatistics errors = row.errors().orElse(ErrorStatistics.of());
            text.append(String.format(
                    Locale.ROOT,
                    "%s,%d,%.4e,%.4e,%.4e,%.4g,%.4g,%.4g%n",
                    row.name().replace(",", ""),
                    errors.count(),
                    errors.median(),
                    errors.percentile95(),
                    errors.maximum(),
                    row.microseconds(),
                    row.makingSeconds(),
                    row.bytes() * 1e-6));
        }
        write(PerformancePage.stem(figures), text);
    }

    /** Seconds of making and of a frame. */
    void write(Growth growth) {
        if (!growth.points().isEmpty()) {
            Plot plot = new Plot(new Frame(
                    growth.title(), Axis.logarithmic(growth.axis()), Axis.logarithmic("time / s"), WIDTH, HEIGHT));
            growth.byMethod().forEach((method, points) -> {
                double[] x = points.stream().mapToDouble(Growth.Point::x).toArray();
                plot.lineWithPoints(method + ": a frame", x, of(points, Measured::frameSeconds));
                plot.lineWithPoints(method + ": making", x, of(points, Measured::makingSeconds));
            });
            plot.write(folder.resolve(growth.key() + ".png"), overwrite, Map.of("Title", growth.title()));
        }
        StringBuilder text = new StringBuilder(growth.axis() + ",method,making s,frame s,us per pixel,MB\n");
        for (Growth.Point point : growth.points()) {
            Measured measured = point.measured();
            text.append(String.format(
                    Locale.ROOT,
                    "%.6g,%s,%.4g,%.4g,%.4g,%.4g%n",
                    point.x(),
                    point.method().replace(",", ""),
                    measured.makingSeconds(),
                    measured.frameSeconds(),
                    measured.microseconds(),
                    measured.bytes() * 1e-6));
        }
        write(growth.key(), text);
    }

    private void write(String stem, StringBuilder text) {
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(folder.resolve(stem + ".csv"), overwrite, stream -> stream.write(bytes));
    }

    private static double[] of(List<Growth.Point> points, ToDoubleFunction<Measured> value) {
        return points.stream()
                .map(Growth.Point::measured)
                .mapToDouble(value)
                .map(seconds -> Math.max(LEAST, seconds))
                .toArray();
    }

    private static double[] values(List<Measured> rows, ToDoubleFunction<Measured> value) {
        return rows.stream().mapToDouble(value).toArray();
    }
}
