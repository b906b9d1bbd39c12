package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.NumberFormat;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.TickUnits;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.util.ShapeUtils;
import org.jfree.data.Range;

/** Style of all plots: white, sans serif, thin grid, colors that color-blind people can distinguish. */
public final class PlotStyle {
    /** Colors of series, from M. Okabe and K. Ito, "Color Universal Design" (2008), without the yellow, which is too pale on white. */
    private static final int[] COLORS = {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x000000};

    /** Marks of series, which differ so that prints in gray can be read. */
    private static final Shape[] SHAPES = {
        new Ellipse2D.Double(-4, -4, 8, 8),
        new Rectangle2D.Double(-4, -4, 8, 8),
        ShapeUtils.createUpTriangle(4.5f),
        ShapeUtils.createDiamond(5),
        ShapeUtils.createDownTriangle(4.5f),
        ShapeUtils.createDiagonalCross(3.5f, 0.8f),
        ShapeUtils.createRegularCross(4.5f, 0.8f)
    };

    /** Twice as wide as the other marks, which stay visible inside. */
    static final Shape RING = new Ellipse2D.Double(-8, -8, 16, 16);

    static final Shape FRAME = new Rectangle2D.Double(-8, -8, 16, 16);
    static final BasicStroke RING_STROKE = new BasicStroke(2.5f);
    static final BasicStroke LINE = new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    static final BasicStroke THIN = new BasicStroke(1.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    static final NumberFormat NUMBERS = new DecimalFormat("0.######", DecimalFormatSymbols.getInstance(Locale.ROOT));
    private static final TickUnits DECADES = units(1, 2, 3, 5);
    private static final TickUnits DOUBLINGS = units(Math.log10(2), 1);
    // Least ratio of a logarithmic axis's ends, so that two powers of two lie on it.
    private static final double LEAST_RATIO = 5;
    // Ratio of its ends below which a logarithmic axis has labels at 1, 2, 4, 8 and so on.
    private static final double LARGEST_DOUBLINGS_RATIO = 100;
    private static final NumberFormat POWERS = powers();

    /** Format of labels of values that are given by their decimal logarithms. */
    static final NumberFormat POWERS_BY_EXPONENT =
            new DecimalFormat("'1e'0;'1e-'0", DecimalFormatSymbols.getInstance(Locale.ROOT));

    public static final Color INK = new Color(0x222222);
    /** Vermillion, which is visible on dark and on light. */
    static final Color MARK = new Color(0xD55E00);

    static final Font TITLE_FONT = PlotFont.bold(18);
    static final Font LABEL_FONT = PlotFont.plain(16);
    static final Font TICK_FONT = PlotFont.plain(14);
    static final Color OUTLINE = new Color(0x888888);
    private static final Color GRID = new Color(0xDDDDDD);
    private static final double MARGIN = 16;

    private PlotStyle() {}

    /** Returns the color of a series by its number, from 0. */
    public static Color color(int index) {
        return new Color(COLORS[index % COLORS.length]);
    }

    static Shape shape(int index) {
        return SHAPES[index % SHAPES.length];
    }

    static ValueAxis horizontal(Plot.Axis description) {
        return axis(description, new RectangleInsets(2, 10, 2, 10));
    }

    static ValueAxis upright(Plot.Axis description) {
        return axis(description, new RectangleInsets(10, 4, 10, 4));
    }

    private static ValueAxis axis(Plot.Axis description, RectangleInsets labelMargins) {
        ValueAxis axis;
        if (description.scale() == Plot.Scale.LINEAR) {
            NumberAxis linear = new NumberAxis(description.label());
            linear.setAutoRangeIncludesZero(false);
            linear.setAutoRangeStickyZero(false);
            linear.setNumberFormatOverride(NUMBERS);
            axis = linear;
        } else {
            LogAxis logarithmic = new LogAxis(description.label());
            logarithmic.setNumberFormatOverride(POWERS);
            axis = logarithmic;
        }
        axis.setLabelFont(LABEL_FONT);
        axis.setLabelPaint(INK);
        axis.setLabelInsets(new RectangleInsets(6, 6, 6, 6));
        axis.setTickLabelFont(TICK_FONT);
        axis.setTickLabelPaint(INK);
        axis.setTickLabelInsets(labelMargins);
        axis.setTickMarkPaint(INK);
        axis.setTickMarkOutsideLength(4);
        axis.setAxisLineVisible(false);
        return axis;
    }

    /** Gives logarithmic axes labels that suit the range of the data, and a short range more of them. */
    static void adaptUnits(XYPlot plot) {
        for (ValueAxis axis : List.of(plot.getDomainAxis(), plot.getRangeAxis())) {
            if (axis instanceof LogAxis logarithmic) {
                Range range = plot.getDataRange(axis);
                double ratio = range.getUpperBound() / range.getLowerBound();
                logarithmic.setStandardTickUnits(ratio < LARGEST_DOUBLINGS_RATIO ? DOUBLINGS : DECADES);
                double margin = Math.max(Math.pow(ratio, axis.getLowerMargin()), Math.sqrt(LEAST_RATIO / ratio));
                axis.setRange(range.getLowerBound() / margin, range.getUpperBound() * margin);
            }
        }
    }

    static XYPlot plot(ValueAxis x, ValueAxis y) {
        XYPlot plot = new XYPlot(null, x, y, null);
        plot.setBackgroundPaint(Color.WHITE);
        plot.setOutlinePaint(INK);
        plot.setOutlineStroke(new BasicStroke(1));
        plot.setDomainGridlinePaint(GRID);
        plot.setRangeGridlinePaint(GRID);
        plot.setDomainGridlineStroke(new BasicStroke(1));
        plot.setRangeGridlineStroke(new BasicStroke(1));
        plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
        return plot;
    }

    static JFreeChart chart(String title, XYPlot plot) {
        JFreeChart chart = new JFreeChart(title, TITLE_FONT, plot, false);
        chart.setBackgroundPaint(Color.WHITE);
        chart.getTitle().setPaint(INK);
        chart.getTitle().setMargin(0, 0, 8, 0);
        chart.setPadding(new RectangleInsets(MARGIN, MARGIN, MARGIN, MARGIN));
        return chart;
    }

    static LegendTitle legend(XYPlot plot, RectangleEdge edge) {
        LegendTitle legend = new LegendTitle(plot);
        legend.setPosition(edge);
        legend.setItemFont(TICK_FONT);
        legend.setItemPaint(INK);
        legend.setFrame(BlockBorder.NONE);
        legend.setItemLabelPadding(new RectangleInsets(4, 4, 4, 4));
        return legend;
    }

    /** Returns the margins that give a unit the same length along x and y. Draws the plot, since its layout is known only then. */
    static RectangleInsets equalScales(JFreeChart chart, int width, int height, double extentX, double extentY) {
        ChartRenderingInfo info = new ChartRenderingInfo();
        chart.getXYPlot().setInsets(RectangleInsets.ZERO_INSETS);
        chart.createBufferedImage(width, height, BufferedImage.TYPE_INT_RGB, info);
        Rectangle2D area = info.getPlotInfo().getDataArea();
        double scale = Math.min(area.getWidth() / extentX, area.getHeight() / extentY);
        double left = 0.5 * (area.getWidth() - scale * extentX);
        double top = 0.5 * (area.getHeight() - scale * extentY);
        return new RectangleInsets(top, left, top, left);
    }

    private static TickUnits units(double... steps) {
        TickUnits units = new TickUnits();
        DoubleStream.of(steps).mapToObj(NumberTickUnit::new).forEach(units::add);
        return units;
    }

    private static NumberFormat powers() {
        DecimalFormatSymbols symbols = DecimalFormatSymbols.getInstance(Locale.ROOT);
        symbols.setExponentSeparator("e");
        return new DecimalFormat("0.##E0", symbols);
    }
}
