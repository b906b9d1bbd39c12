package sunbeam.app.plot;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Map;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import sunbeam.app.output.Overwrite;
import sunbeam.app.output.PngWriter;

/**
 * Lines and points over x in Sunbeam's look, drawn without a display. Units belong into the axes' labels
 * ({@code wavelength / nm}). Series get the colours and marks of {@link PlotStyle} in the order in which they are
 * added.
 */
public final class Plot {
    private final XYChart chart;
    private final Scale xScale;
    private final Scale yScale;
    private int seriesCount;

    private enum Form {
        LINE,
        POINTS,
        LINE_WITH_POINTS
    }

    /**
     * What stands around the series.
     *
     * @param width pixels
     * @param height pixels
     */
    public record Frame(String title, Axis x, Axis y, int width, int height) {
        private static final int WIDTH = 900;
        private static final int HEIGHT = 600;

        /** The usual 900 x 600 pixels. */
        public Frame(String title, Axis x, Axis y) {
            this(title, x, y, WIDTH, HEIGHT);
        }
    }

    /** An axis's label, with its unit, and scale. */
    public record Axis(String label, Scale scale) {
        public static Axis linear(String label) {
            return new Axis(label, Scale.LINEAR);
        }

        public static Axis logarithmic(String label) {
            return new Axis(label, Scale.LOGARITHMIC);
        }
    }

    public Plot(Frame frame) {
        chart = new XYChart(frame.width(), frame.height());
        chart.setTitle(frame.title());
        chart.setXAxisTitle(frame.x().label());
        chart.setYAxisTitle(frame.y().label());
        xScale = frame.x().scale();
        yScale = frame.y().scale();
        PlotStyle.apply(chart.getStyler(), xScale, yScale);
    }

    /** Adds points joined by a line, without marks: many points on a smooth curve. */
    public Plot line(String name, double[] x, double[] y) {
        return add(name, x, y, Form.LINE);
    }

    /** Adds points joined by a line, with marks: few points, such as errors over a number of terms. */
    public Plot lineWithPoints(String name, double[] x, double[] y) {
        return add(name, x, y, Form.LINE_WITH_POINTS);
    }

    /** Adds points alone: scattered measurements. */
    public Plot points(String name, double[] x, double[] y) {
        return add(name, x, y, Form.POINTS);
    }

    /** The picture. */
    public BufferedImage draw() {
        if (seriesCount == 0) {
            throw new IllegalStateException("the plot '" + chart.getTitle() + "' has no series");
        }
        return BitmapEncoder.getBufferedImage(chart);
    }

    /**
     * Writes the picture as PNG, whole or not at all.
     *
     * @param text chunks that say how the data was made, see {@link PngWriter}
     * @throws sunbeam.app.output.OutputException when the file cannot be written
     */
    public void write(Path target, Overwrite overwrite, Map<String, String> text) {
        PngWriter.write(target, overwrite, draw(), text);
    }

    private Plot add(String name, double[] x, double[] y, Form form) {
        check(name, "x", x, xScale);
        check(name, "y", y, yScale);
        if (x.length != y.length || x.length == 0) {
            throw new IllegalArgumentException(
                    "series '" + name + "' has " + x.length + " x values and " + y.length + " y values");
        }
        XYSeries series = chart.addSeries(name, x, y);
        series.setXYSeriesRenderStyle(form == Form.POINTS ? XYSeriesRenderStyle.Scatter : XYSeriesRenderStyle.Line);
        Marker marker = form == Form.LINE ? SeriesMarkers.NONE : PlotStyle.marker(seriesCount);
        series.setMarker(marker);
        seriesCount++;
        return this;
    }

    private static void check(String name, String axis, double[] values, Scale scale) {
        for (double value : values) {
            boolean drawable = Double.isFinite(value) && (scale == Scale.LINEAR || value > 0);
            if (!drawable) {
                throw new IllegalArgumentException("series '" + name + "': " + axis + " = " + value
                        + " has no place on a " + (scale == Scale.LINEAR ? "linear" : "logarithmic") + " axis");
            }
        }
    }
}
