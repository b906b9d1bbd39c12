package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.XYBoxAnnotation;
import org.jfree.chart.annotations.XYPointerAnnotation;
import org.jfree.chart.annotations.XYTextAnnotation;
import org.jfree.chart.axis.AxisLocation;
import org.jfree.chart.axis.AxisSpace;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.SeriesRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.LookupPaintScale;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.PaintScaleLegend;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.DefaultXYDataset;

/** Matrix of values in color over two axes, with a color bar, curves and marks, in the style of {@link Plot}. It is drawn once. */
public final class HeatMap {
    // Ratio of the sides from which a matrix is a thin strip, which is drawn broader than its scales.
    private static final double THIN_STRIP_RATIO = 10;
    private static final double SPACE_LEFT = 120;
    private static final double SPACE_BELOW = 94;
    private static final double GAP = 12;
    private static final int SHADES = 256;
    private static final float CURVE_WIDTH = 4;
    private static final float RIM_WIDTH = 1.5f;
    private static final Color SHADE = new Color(0, 0, 0, 150);
    private static final float[] DOTTED = {4, 9};

    private final Frame frame;
    private final Values values;
    private final StringBuilder names = new StringBuilder();
    private final DefaultXYDataset curves = new DefaultXYDataset();
    private final XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);

    /** Title, axis labels and size in pixels; with equal scales, a unit is as long along y as along x unless the matrix is a thin strip. */
    public record Frame(String title, String xLabel, String yLabel, int width, int height, boolean equalScales) {}

    /** Values {@code [row][column]}, row 0 at the lowest y, and the outer edges of the first and the last column and row. */
    public record Values(double[][] rows, double[] xRange, double[] yRange, Colors colors, Reduction reduction) {
        /** Returns the outer edges of cells with these evenly spaced centers, at least two. */
        public static double[] around(double[] centers) {
            double half = 0.5 * (centers[centers.length - 1] - centers[0]) / (centers.length - 1);
            return new double[] {centers[0] - half, centers[centers.length - 1] + half};
        }
    }

    public enum Reduction {
        /** The largest value, so that thin ridges and peaks stay visible. */
        LARGEST,
        /** The value in the middle of the pixel, so that a noisy matrix stays as noisy. */
        MIDDLE
    }

    /** Colors of values from {@code low}, positive if the scale is logarithmic, to {@code high}. */
    public record Colors(String label, double low, double high, Plot.Scale scale, ColorMap map) {
        double position(double value) {
            return scale == Plot.Scale.LINEAR
                    ? (value - low) / (high - low)
                    : Math.log(Math.max(value, low) / low) / Math.log(high / low);
        }
    }

    public HeatMap(Frame frame, Values values) {
        this.frame = frame;
        this.values = values;
    }

    /** Adds a curve with an entry in the legend and a dark rim, or a white one if it is black; points that are NaN or outside the axes interrupt it. */
    public HeatMap curve(String name, double[] x, double[] y, int rgb, float... dashes) {
        add(name, x, y, rgb, dashes, true);
        return this;
    }

    /** Adds a curve between two dotted ones, with one entry in the legend, where all three are finite. */
    public HeatMap interval(String name, double[] x, double[] y, double[] oneSide, double[] otherSide, int rgb) {
        for (double[] side : List.of(oneSide, otherSide)) {
            add(name + curves.getSeriesCount(), x, atCommonPoints(side, y, oneSide, otherSide), rgb, DOTTED, false);
        }
        add(name, x, atCommonPoints(y, oneSide, otherSide), rgb, new float[0], true);
        return this;
    }

    private static double[] atCommonPoints(double[]... series) {
        double[] values = series[0].clone();
        for (int i = 0; i < values.length; i++) {
            for (double[] other : series) {
                values[i] = Double.isFinite(other[i]) ? values[i] : Double.NaN;
            }
        }
        return values;
    }

    private void add(String name, double[] x, double[] y, int rgb, float[] dashes, boolean inLegend) {
        series(
                name + " rim",
                x,
                y,
                rgb == 0 ? Color.WHITE : Color.BLACK,
                PlotStyle.stroke(CURVE_WIDTH + 2 * RIM_WIDTH, dashes),
                false);
        series(name, x, y, new Color(rgb), PlotStyle.stroke(CURVE_WIDTH, dashes), inLegend);
    }

    private void series(String name, double[] x, double[] y, Color color, BasicStroke stroke, boolean inLegend) {
        int index = curves.getSeriesCount();
        names.append(name);
        curves.addSeries(PlotStyle.typeset(name), new double[][] {x, y});
        renderer.setSeriesPaint(index, color);
        renderer.setSeriesStroke(index, stroke);
        renderer.setSeriesVisibleInLegend(index, inLegend);
    }

    public HeatMap mark(String label, double x, double y) {
        boolean right = x > 0.5 * (values.xRange()[0] + values.xRange()[1]);
        XYPointerAnnotation arrow =
                new XYPointerAnnotation(PlotStyle.typeset(label), x, y, (right ? 0.75 : 0.25) * Math.PI);
        arrow.setArrowPaint(PlotStyle.MARK);
        arrow.setArrowStroke(new BasicStroke(4));
        arrow.setBaseRadius(60);
        arrow.setArrowLength(14);
        arrow.setArrowWidth(8);
        arrow.setTextAnchor(right ? TextAnchor.CENTER_RIGHT : TextAnchor.CENTER_LEFT);
        annotate(arrow);
        return this;
    }

    public HeatMap scaleBar(String label, double length) {
        double left = values.xRange()[0] + 0.03 * (values.xRange()[1] - values.xRange()[0]);
        double unit = 0.015 * (values.yRange()[1] - values.yRange()[0]);
        double bottom = values.yRange()[0] + 3 * unit;
        renderer.addAnnotation(new XYBoxAnnotation(
                left, bottom, left + length, bottom + unit, PlotStyle.stroke(2), Color.BLACK, Color.WHITE));
        XYTextAnnotation text = new XYTextAnnotation(PlotStyle.typeset(label), left, bottom + 3 * unit);
        text.setTextAnchor(TextAnchor.BOTTOM_LEFT);
        annotate(text);
        return this;
    }

    private void annotate(XYTextAnnotation text) {
        text.setFont(PlotStyle.LABEL_FONT);
        text.setPaint(Color.WHITE);
        text.setBackgroundPaint(SHADE);
        renderer.addAnnotation(text);
    }

    public Drawing draw() {
        return draw(null);
    }

    Drawing draw(ChartRenderingInfo info) {
        ValueAxis horizontal = PlotStyle.horizontal(Plot.Axis.linear(frame.xLabel()));
        horizontal.setRange(values.xRange()[0], values.xRange()[1]);
        ValueAxis upright = PlotStyle.upright(Plot.Axis.linear(frame.yLabel()));
        upright.setRange(values.yRange()[0], values.yRange()[1]);
        XYPlot plot = PlotStyle.plot(horizontal, upright);
        plot.setInsets(RectangleInsets.ZERO_INSETS);
        plot.setDomainGridlinesVisible(false);
        plot.setRangeGridlinesVisible(false);
        plot.setDataset(curves);
        plot.setRenderer(renderer);
        // Curves lie on their rims, which are added before them.
        plot.setSeriesRenderingOrder(SeriesRenderingOrder.FORWARD);
        // Without this setting, each segment begins with a dash of its own.
        renderer.setDrawSeriesLineAsPath(true);
        renderer.setLegendLine(new Line2D.Double(-32, 0, 32, 0));
        plot.setBackgroundImage(cells());
        plot.setBackgroundImageAlpha(1);
        AxisSpace space = new AxisSpace();
        space.setLeft(SPACE_LEFT);
        space.setBottom(SPACE_BELOW);
        plot.setFixedRangeAxisSpace(space);
        plot.setFixedDomainAxisSpace(space);
        JFreeChart chart = PlotStyle.chart(frame.title(), plot);
        if (curves.getSeriesCount() > 0) {
            chart.addSubtitle(PlotStyle.legend(plot, names.toString()));
        }
        PaintScaleLegend bar = colorBar();
        chart.addSubtitle(bar);
        double extentX = values.xRange()[1] - values.xRange()[0];
        double extentY = values.yRange()[1] - values.yRange()[0];
        boolean thin = extentX >= THIN_STRIP_RATIO * extentY || extentY >= THIN_STRIP_RATIO * extentX;
        // Two passes are needed: the labels of the color bar, and so its width, depend on its height.
        for (int pass = 0; pass < 2 && frame.equalScales() && !thin; pass++) {
            RectangleInsets insets = PlotStyle.equalScales(chart, frame.width(), frame.height(), extentX, extentY);
            plot.setInsets(insets);
            bar.setMargin(insets.getTop(), GAP, insets.getBottom() + SPACE_BELOW, 0);
        }
        return PlotStyle.drawing(chart, frame.width(), frame.height(), info);
    }

    /** Returns an image with one pixel for each cell: JFreeChart would draw millions of rectangles. */
    private BufferedImage cells() {
        int width = Math.min(values.rows()[0].length, frame.width() / 2);
        int height = Math.min(values.rows().length, frame.height() / 2);
        BufferedImage cells = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double position = values.colors().position(cell(x, width, y, height));
                cells.setRGB(x, height - 1 - y, values.colors().map().at(position));
            }
        }
        return cells;
    }

    private double cell(int x, int width, int y, int height) {
        int rows = values.rows().length;
        int columns = values.rows()[0].length;
        if (values.reduction() == Reduction.MIDDLE) {
            return values.rows()[(2 * y + 1) * rows / (2 * height)][(2 * x + 1) * columns / (2 * width)];
        }
        double largest = Double.NEGATIVE_INFINITY;
        for (int row = y * rows / height; row < (y + 1) * rows / height; row++) {
            for (int column = x * columns / width; column < (x + 1) * columns / width; column++) {
                largest = Math.max(largest, values.rows()[row][column]);
            }
        }
        return largest;
    }

    /** Returns the color bar. JFreeChart shades it in equal steps of its axis, so the axis of a logarithmic bar has exponents of 10. */
    private PaintScaleLegend colorBar() {
        Colors colors = values.colors();
        boolean linear = colors.scale() == Plot.Scale.LINEAR;
        double low = linear ? colors.low() : Math.log10(colors.low());
        double high = linear ? colors.high() : Math.log10(colors.high());
        NumberAxis axis = (NumberAxis) PlotStyle.upright(Plot.Axis.linear(colors.label()));
        axis.setRange(low, high);
        if (!linear) {
            axis.setNumberFormatOverride(PlotStyle.POWERS_BY_EXPONENT);
            axis.setTickUnit(new NumberTickUnit(1));
        }
        LookupPaintScale shades = new LookupPaintScale(low, high, Color.WHITE);
        for (int i = 0; i < SHADES; i++) {
            shades.add(low + (high - low) * i / SHADES, new Color(colors.map().at((i + 0.5) / SHADES)));
        }
        PaintScaleLegend bar = new PaintScaleLegend(shades, axis);
        bar.setMargin(0, GAP, SPACE_BELOW, 0);
        bar.setPosition(RectangleEdge.RIGHT);
        bar.setAxisLocation(AxisLocation.BOTTOM_OR_RIGHT);
        bar.setStripWidth(28);
        bar.setSubdivisionCount(SHADES);
        bar.setStripOutlineVisible(true);
        bar.setStripOutlinePaint(PlotStyle.INK);
        return bar;
    }

    /** Map from values between 0 and 1 to colors whose lightness grows, by evenly spaced colors 0xRRGGBB. */
    public record ColorMap(int... points) {
        /** Viridis (S. van der Walt and N. Smith, matplotlib, CC0), at nine evenly spaced points. */
        public static final ColorMap VIRIDIS =
                new ColorMap(0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725);

        /** Heights as microscopes show them. */
        public static final ColorMap GRAY = new ColorMap(0x000000, 0xFFFFFF);

        /** Returns a value's color as 0xRRGGBB, linear between the points; the ends' outside 0..1, white for NaN. */
        public int at(double value) {
            if (Double.isNaN(value)) {
                return 0xFFFFFF;
            }
            double position = Math.max(0, Math.min(1, value)) * (points.length - 1);
            int index = Math.min(points.length - 2, (int) position);
            double fraction = position - index;
            int color = 0;
            for (int shift = 16; shift >= 0; shift -= 8) {
                double before = (points[index] >> shift) & 0xFF;
                double after = (points[index + 1] >> shift) & 0xFF;
                color |= (int) Math.round(before + fraction * (after - before)) << shift;
            }
            return color;
        }
    }
}
