package sunbeam.app.plot;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.markers.SeriesMarkers;
import sunbeam.app.output.Overwrite;
import sunbeam.app.output.PngWriter;

/**
 * Lines and points over x in Sunbeam's look, drawn without a display. Units belong into the axes' labels
 * ({@code wavelength / nm}). Series get the colours and marks of {@link PlotStyle} in the order in which they are
 * added.
 */
public final class Plot {
    /** An inner place of a range, in no simple ratio to it. */
    private static final double OFF_GRID = 0.3819660113;

    private final Frame frame;
    private final List<Series> allSeries = new ArrayList<>();

    private enum Form {
        LINE,
        POINTS,
        LINE_WITH_POINTS,
        RINGS
    }

    private record Series(String name, List<Double> x, List<Double> y, Form form) {
        static Series of(String name, double[] x, double[] y, Form form) {
            return new Series(
                    name,
                    Arrays.stream(x).boxed().toList(),
                    Arrays.stream(y).boxed().toList(),
                    form);
        }
    }

    /** How values are laid out along an axis. */
    public enum Scale {
        LINEAR,
        /** Decimal logarithm; values must be positive. */
        LOGARITHMIC
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

    public Plot(Frame frame) {
        this.frame = frame;
    }

    /** Adds points joined by a line, without marks: many points on a smooth curve. */
    public Plot line(String name, double[] x, double[] y) {
        return add(Series.of(name, x, y, Form.LINE));
    }

    /** Adds points joined by a line, with marks: few points, such as errors over a number of terms. */
    public Plot lineWithPoints(String name, double[] x, double[] y) {
        return add(Series.of(name, x, y, Form.LINE_WITH_POINTS));
    }

    /** Adds points alone: scattered measurements. */
    public Plot points(String name, double[] x, double[] y) {
        return add(Series.of(name, x, y, Form.POINTS));
    }

    /**
     * Adds points to be seen before all others, as black rings around what they may coincide with; every
     * series after the first as frames.
     */
    public Plot rings(String name, double[] x, double[] y) {
        return add(Series.of(name, x, y, Form.RINGS));
    }

    /**
     * The picture.
     *
     * @throws IllegalStateException when there is no series
     */
    public BufferedImage draw() {
        if (allSeries.isEmpty()) {
            throw new IllegalStateException("the plot '" + frame.title() + "' has no series");
        }
        XYChart chart = new XYChart(frame.width(), frame.height());
        chart.setTitle(frame.title());
        chart.setXAxisTitle(frame.x().label());
        chart.setYAxisTitle(frame.y().label());
        PlotStyle.apply(chart.getStyler(), frame.x().scale(), frame.y().scale());
        for (int index = 0; index < allSeries.size(); index++) {
            addTo(chart, allSeries.get(index), index);
        }
        // The title already says what a single series is.
        chart.getStyler().setLegendVisible(allSeries.size() > 1);
        addTickBreaker(chart);
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

    private Plot add(Series series) {
        if (series.x.size() != series.y.size() || series.x.isEmpty()) {
            throw new IllegalArgumentException("series '" + series.name + "' has " + series.x.size() + " x values and "
                    + series.y.size() + " y values");
        }
        check(series.name, "x", series.x, frame.x().scale());
        check(series.name, "y", series.y, frame.y().scale());
        allSeries.add(series);
        return this;
    }

    private static void check(String name, String axis, List<Double> values, Scale scale) {
        for (double value : values) {
            boolean drawable = Double.isFinite(value) && (scale == Scale.LINEAR || value > 0);
            if (!drawable) {
                throw new IllegalArgumentException("series '" + name + "': " + axis + " = " + value
                        + " has no place on a " + (scale == Scale.LINEAR ? "linear" : "logarithmic") + " axis");
            }
        }
    }

    private void addTo(XYChart chart, Series series, int index) {
        XYSeries drawn = chart.addSeries(series.name, series.x, series.y);
        boolean joined = series.form == Form.LINE || series.form == Form.LINE_WITH_POINTS;
        drawn.setXYSeriesRenderStyle(joined ? XYSeriesRenderStyle.Line : XYSeriesRenderStyle.Scatter);
        drawn.setMarker(
                switch (series.form) {
                    case LINE -> SeriesMarkers.NONE;
                    case RINGS -> new RingMarker(isFirstOfRings(series));
                    default -> PlotStyle.marker(index);
                });
        if (series.form == Form.RINGS) {
            drawn.setMarkerColor(PlotStyle.INK);
        }
    }

    private boolean isFirstOfRings(Series series) {
        return allSeries.stream()
                .filter(other -> other.form == Form.RINGS)
                .findFirst()
                .filter(series::equals)
                .isPresent();
    }

    /**
     * XChart 4.0.3 labels an axis whose values are evenly spaced at every so many of them (380, 397, 414), too closely.
     * One more point, which is not seen, makes it take round numbers.
     */
    private void addTickBreaker(XYChart chart) {
        double[] x = {innerValue(Series::x)};
        double[] y = {innerValue(Series::y)};
        XYSeries breaker = chart.addSeries(" ", x, y);
        breaker.setXYSeriesRenderStyle(XYSeriesRenderStyle.Scatter);
        breaker.setMarker(SeriesMarkers.NONE);
        breaker.setShowInLegend(false);
    }

    private double innerValue(Function<Series, List<Double>> axis) {
        DoubleSummaryStatistics range = allSeries.stream()
                .flatMap(series -> axis.apply(series).stream())
                .mapToDouble(Double::doubleValue)
                .summaryStatistics();
        return range.getMin() + OFF_GRID * (range.getMax() - range.getMin());
    }
}
