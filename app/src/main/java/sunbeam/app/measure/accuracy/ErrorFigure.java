package sunbeam.app.measure.accuracy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.ToDoubleFunction;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.files.plot.Plot.Frame;
import sunbeam.app.measure.errors.ErrorStatistics;

/**
 * Some curves that belong into one plot and one table.
 *
 * @param key part of the file names: lower-case letters
 * @param title above the plot
 * @param x the axis of what was varied
 * @param y the label of the axis of errors
 * @param xColumn what was varied, as a column's name
 * @param curves drawn as lines
 * @param thesis the thesis's settings, drawn as points
 * @param style what is drawn of each curve
 * @param remarks what could not be measured
 */
public record ErrorFigure(
        String key,
        String title,
        Axis x,
        String y,
        String xColumn,
        List<ErrorCurve> curves,
        List<ErrorCurve> thesis,
        Style style,
        List<String> remarks)
        implements Figure {
    private static final int WIDTH = 820;
    private static final int HEIGHT = 480;
    // Logarithms have no place for an error of 0, nor doubles digits below this.
    private static final double LEAST = 1e-16;
    // What has grown beyond all bounds is drawn at the top.
    private static final double MOST = 1e6;

    /** What is drawn of each curve; tables have everything. */
    public enum Style {
        MEDIANS,
        MEDIANS_AND_PERCENTILES,
        /** Both, and what a tolerance on the x axis allows them to be. */
        AGAINST_TOLERANCE
    }

    @Override
    public void writePlot(Path file, Overwrite overwrite) {
        Plot plot = new Plot(new Frame(title, x, Axis.logarithmic(y), WIDTH, HEIGHT));
        for (ErrorCurve curve : curves) {
            if (style != Style.MEDIANS) {
                plot.lineWithPoints(curve.name() + ", median", xOf(curve), yOf(curve, ErrorStatistics::median));
                plot.lineWithPoints(curve.name() + ", 95 %", xOf(curve), yOf(curve, ErrorStatistics::percentile95));
            } else {
                plot.lineWithPoints(curve.name(), xOf(curve), yOf(curve, ErrorStatistics::median));
            }
        }
        if (style == Style.AGAINST_TOLERANCE) {
            double[] tolerances = xOf(curves.get(0));
            plot.line("allowed, median", tolerances, tolerances);
            plot.line("allowed, 95 %", tolerances, scaled(tolerances, ErrorStatistics.PERCENTILE_FACTOR));
        }
        for (ErrorCurve point : thesis) {
            plot.rings(point.name(), xOf(point), yOf(point, ErrorStatistics::median));
        }
        plot.write(file, overwrite, Map.of("Title", title));
    }

    // One row for each value of what was varied; NaN where a curve has none.
    @Override
    public void writeTable(Path file, Overwrite overwrite) {
        List<ErrorCurve> all = new ArrayList<>(curves);
        all.addAll(thesis);
        List<String> columns = new ArrayList<>(List.of(xColumn));
        for (ErrorCurve curve : all) {
            columns.addAll(List.of(curve.name() + " median", curve.name() + " p95", curve.name() + " maximum"));
        }
        TreeSet<Double> values = new TreeSet<>();
        all.forEach(curve -> values.addAll(curve.x()));
        AtomicFile.write(file, overwrite, stream -> {
            try (CsvWriter writer = new CsvWriter(stream, columns)) {
                for (double value : values) {
                    writer.row(row(value, all, columns.size()));
                }
            }
        });
    }

    private static double[] row(double value, List<ErrorCurve> curves, int columns) {
        double[] cells = new double[columns];
        Arrays.fill(cells, Double.NaN);
        cells[0] = value;
        for (int i = 0; i < curves.size(); i++) {
            int at = curves.get(i).x().indexOf(value);
            if (at >= 0) {
                ErrorStatistics errors = curves.get(i).errors().get(at);
                cells[3 * i + 1] = errors.median();
                cells[3 * i + 2] = errors.percentile95();
                cells[3 * i + 3] = errors.maximum();
            }
        }
        return cells;
    }

    private static double[] scaled(double[] values, double factor) {
        return Arrays.stream(values).map(value -> factor * value).toArray();
    }

    /** An error with a place on a logarithmic axis. */
    static double drawable(double error) {
        return Math.max(LEAST, Math.min(MOST, error));
    }

    /** A tolerance or error for people: 1e-3. */
    static String number(double value) {
        return String.format(Locale.ROOT, "%.0e", value).replace("e-0", "e-");
    }

    private static double[] xOf(ErrorCurve curve) {
        return curve.x().stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double[] yOf(ErrorCurve curve, ToDoubleFunction<ErrorStatistics> value) {
        return curve.errors().stream()
                .mapToDouble(value)
                .map(ErrorFigure::drawable)
                .toArray();
    }
}
