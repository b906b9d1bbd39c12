package sunbeam.app.measure.accuracy;

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

/**
 * Error and time of the methods on one patch.
 *
 * @param patch its name
 * @param entries the thesis's settings first, which times are compared with
 * @param remarks what could not be measured
 */
record MethodsFigure(String patch, List<Entry> entries, List<String> remarks) implements Figure {
    /** The note of what approximates nothing but the reference. */
    static final String FULL = "";

    private static final int WIDTH = 820;
    private static final int HEIGHT = 480;

    /**
     * One method.
     *
     * @param name with what distinguishes it
     * @param errors of X, Y, Z
     * @param microseconds per pixel
     * @param note what it approximates, where that is not the reference's power under the Gaussian window
     */
    record Entry(String name, ErrorStatistics errors, double microseconds, String note) {}

    MethodsFigure {
        entries = List.copyOf(entries);
        remarks = List.copyOf(remarks);
    }

    @Override
    public String key() {
        return "methods";
    }

    @Override
    public String title() {
        return patch + ": error over time of the methods";
    }

    /** How many times faster than the thesis's settings. */
    double speed(Entry entry) {
        return entries.get(0).microseconds() / entry.microseconds();
    }

    @Override
    public void writePlot(Path file, Overwrite overwrite) {
        Plot plot = new Plot(new Frame(
                title(),
                Axis.logarithmic("time per pixel / us"),
                Axis.logarithmic("relative error of XYZ (median)"),
                WIDTH,
                HEIGHT));
        List<Entry> planned = entries.stream()
                .skip(1)
                .filter(entry -> entry.note().equals(FULL))
                .toList();
        plot.lineWithPoints(
                "full, planned", values(planned, Entry::microseconds), values(planned, MethodsFigure::error));
        for (Entry entry : entries) {
            if (!entry.note().equals(FULL)) {
                plot.points(entry.name(), values(List.of(entry), Entry::microseconds), new double[] {error(entry)});
            }
        }
        Entry thesis = entries.get(0);
        plot.rings(thesis.name(), new double[] {thesis.microseconds()}, new double[] {error(thesis)});
        plot.write(file, overwrite, Map.of("Title", title()));
    }

    private static double error(Entry entry) {
        return ErrorFigure.drawable(entry.errors().median());
    }

    private static double[] values(List<Entry> entries, ToDoubleFunction<Entry> value) {
        return entries.stream().mapToDouble(value).toArray();
    }

    @Override
    public void writeTable(Path file, Overwrite overwrite) {
        StringBuilder text = new StringBuilder(
                "method,directions,XYZ median,XYZ p95,XYZ maximum,us per pixel,times faster than thesis\n");
        for (Entry entry : entries) {
            ErrorStatistics errors = entry.errors();
            text.append(String.format(
                    Locale.ROOT,
                    "%s,%d,%.4e,%.4e,%.4e,%.4g,%.4g%n",
                    entry.name().replace(",", ""),
                    errors.count(),
                    errors.median(),
                    errors.percentile95(),
                    errors.maximum(),
                    entry.microseconds(),
                    speed(entry)));
        }
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(file, overwrite, stream -> stream.write(bytes));
    }
}
