package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.util.Optional;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.xy.DefaultXYDataset;

/**
 * Plot of lines and points over x, drawn without a display. The axes' labels contain the units ({@code wavelength / nm}); values that are
 * NaN are left out. Series get the colors and marks of {@link PlotStyle} in the order in which they are added.
 */
public final class Plot {
    // Points have it too, undrawn, so that all names in a legend begin at one place.
    private static final Line2D LEGEND_LINE = new Line2D.Double(-32, 0, 32, 0);

    private final Frame frame;
    private final XYPlot plot;
    private int count;
    private Optional<Double> equalStep = Optional.empty();
    private int ringSeries;
    private final StringBuilder names = new StringBuilder();

    public enum Scale {
        LINEAR,
        /** Values must be positive. */
        LOGARITHMIC
    }

    public record Axis(String label, Scale scale) {
        public static Axis linear(String label) {
            return new Axis(label, Scale.LINEAR);
        }

        public static Axis logarithmic(String label) {
            return new Axis(label, Scale.LOGARITHMIC);
        }
    }

    public record Frame(String title, Axis x, Axis y, int width, int height) {}

    public Plot(Frame frame) {
        this.frame = frame;
        plot = PlotStyle.plot(PlotStyle.horizontal(frame.x()), PlotStyle.upright(frame.y()));
        // The order of adding, so that rings lie in front.
        plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
    }

    public static Plot linear(String title, String x, String y, int width, int height) {
        return new Plot(new Frame(title, Axis.linear(x), Axis.linear(y), width, height));
    }

    /** Returns the largest of 1, 2, 5 times a power of ten that does not exceed a positive number. */
    public static double round(double number) {
        double power = Math.pow(10, Math.floor(Math.log10(number)));
        double mantissa = number / power;
        return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
    }

    public Plot line(String name, double[] x, double[] y) {
        return line(name, x, y, count);
    }

    /** Adds a line in the color of the series with the given number. */
    public Plot line(String name, double[] x, double[] y, int color) {
        return add(name, x, y, joined(PlotStyle.color(color), PlotStyle.lineStroke(color)));
    }

    public Plot outline(String name, double[] x, double[] y) {
        return add(name, x, y, joined(PlotStyle.OUTLINE, PlotStyle.THIN));
    }

    public Plot points(String name, double[] x, double[] y) {
        return points(name, x, y, count);
    }

    /** Adds points in the color and with the mark of the series with the given number. */
    public Plot points(String name, double[] x, double[] y, int color) {
        return add(name, x, y, marked(PlotStyle.color(color), PlotStyle.shape(color)));
    }

    /** Gives a unit the same length along x and y, both linear, with this step between labels. */
    public Plot equalScales(double step) {
        equalStep = Optional.of(step);
        return this;
    }

    public Plot fromZero() {
        ((NumberAxis) plot.getRangeAxis()).setAutoRangeIncludesZero(true);
        return this;
    }

    /** Adds points in front of all others, as black rings; those of a second such series are square. */
    public Plot rings(String name, double[] x, double[] y) {
        XYLineAndShapeRenderer renderer = marked(PlotStyle.INK, ringSeries++ == 0 ? PlotStyle.RING : PlotStyle.FRAME);
        renderer.setSeriesShapesFilled(0, false);
        renderer.setSeriesOutlineStroke(0, PlotStyle.RING_STROKE);
        renderer.setUseOutlinePaint(true);
        renderer.setSeriesOutlinePaint(0, PlotStyle.INK);
        return add(name, x, y, renderer);
    }

    public Drawing draw() {
        PlotStyle.adaptUnits(plot);
        JFreeChart chart = PlotStyle.chart(frame.title(), plot);
        if (count > 1) {
            chart.addSubtitle(PlotStyle.legend(plot, names.toString()));
        }
        equalStep.ifPresent(step -> equalizeScales(chart, step));
        return PlotStyle.drawing(chart, frame.width(), frame.height(), null);
    }

    private void equalizeScales(JFreeChart chart, double step) {
        NumberAxis x = (NumberAxis) plot.getDomainAxis();
        NumberAxis y = (NumberAxis) plot.getRangeAxis();
        x.setTickUnit(new NumberTickUnit(step, PlotStyle.NUMBERS));
        y.setTickUnit(new NumberTickUnit(step, PlotStyle.NUMBERS));
        double width = x.getRange().getLength();
        double height = y.getRange().getLength();
        plot.setInsets(PlotStyle.equalScales(chart, frame.width(), frame.height(), width, height));
    }

    private Plot add(String name, double[] x, double[] y, XYLineAndShapeRenderer renderer) {
        renderer.setLegendLine(LEGEND_LINE);
        DefaultXYDataset dataset = new DefaultXYDataset();
        names.append(name);
        dataset.addSeries(PlotStyle.typeset(name), new double[][] {x, y});
        plot.setDataset(count, dataset);
        plot.setRenderer(count, renderer);
        count++;
        return this;
    }

    private static XYLineAndShapeRenderer joined(Color color, BasicStroke stroke) {
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
        renderer.setSeriesPaint(0, color);
        renderer.setSeriesStroke(0, stroke);
        // Without this setting, each segment begins with a dash of its own.
        renderer.setDrawSeriesLineAsPath(true);
        return renderer;
    }

    private static XYLineAndShapeRenderer marked(Color color, Shape shape) {
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
        renderer.setSeriesPaint(0, color);
        renderer.setSeriesShape(0, shape);
        return renderer;
    }
}
