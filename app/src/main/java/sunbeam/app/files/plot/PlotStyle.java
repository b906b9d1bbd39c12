package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.FieldPosition;
import java.text.NumberFormat;
import java.text.ParsePosition;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.LogTick;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.TickUnit;
import org.jfree.chart.axis.TickUnits;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.axis.ValueTick;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.util.ShapeUtils;
import org.jfree.data.Range;
import sunbeam.precompute.text.Text;

/** Style of all plots: white, sans serif, thin grid, colors that color-blind people can distinguish. */
public final class PlotStyle {
    /** Colors of series, from M. Okabe and K. Ito, "Color Universal Design" (2008), without the yellow, which is too pale on white. */
    private static final int[] COLORS = {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x000000};

    /** Marks of series, which differ so that prints in gray can be read. */
    private static final Shape[] SHAPES = {
        new Ellipse2D.Double(-7, -7, 14, 14),
        new Rectangle2D.Double(-7, -7, 14, 14),
        ShapeUtils.createUpTriangle(8),
        ShapeUtils.createDiamond(9),
        ShapeUtils.createDownTriangle(8),
        ShapeUtils.createDiagonalCross(6, 1.5f),
        ShapeUtils.createRegularCross(8, 1.5f)
    };

    /** Twice as wide as the other marks, which stay visible inside. */
    static final Shape RING = new Ellipse2D.Double(-14, -14, 28, 28);

    static final Shape FRAME = new Rectangle2D.Double(-14, -14, 28, 28);
    static final BasicStroke RING_STROKE = new BasicStroke(4);
    private static final float LINE_WIDTH = 4;
    static final BasicStroke THIN = new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    // Dashes of lines by their number, so that neighbors differ without color: solid, dashed, dash-dot, dotted.
    private static final float[][] DASHES = {{}, {18, 10}, {22, 8, 4, 8}, {4, 9}};
    static final BasicStroke OUTLINE_STROKE = new BasicStroke(2);
    private static final Pattern EXPONENT = Pattern.compile("\\^([-0-9n]+)");
    private static final String RAISED = "0123456789-n";
    private static final String SUPERSCRIPTS =
            "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079\u207b\u207f";
    static final NumberFormat NUMBERS = new DecimalFormat("0.######", symbols());
    private static final TickUnits DECADES = units(1, 2, 3, 5);
    private static final TickUnits DOUBLINGS = units(Math.log10(2), 1);
    // Least ratio of a logarithmic axis's ends, so that two powers of two lie on it.
    private static final double LEAST_RATIO = 5;
    // Ratio of its ends below which a logarithmic axis has labels at 1, 2, 4, 8 and so on.
    private static final double LARGEST_DOUBLINGS_RATIO = 100;
    private static final NumberFormat POWERS = powers();

    /** Format of labels of values that are given by their decimal logarithms. */
    static final NumberFormat POWERS_BY_EXPONENT = typesetting(value -> Text.format("10^%.0f", value));

    public static final Color INK = new Color(0x222222);
    /** Vermillion, which is visible on dark and on light. */
    static final Color MARK = new Color(0xD55E00);

    static final Font TITLE_FONT = PlotFont.bold(9 * Drawing.POINT);
    static final Font LABEL_FONT = PlotFont.plain((float) Drawing.TEXT_POINTS * Drawing.POINT);
    static final Color OUTLINE = new Color(0x888888);
    private static final Color GRID = new Color(0xDDDDDD);
    private static final double MARGIN = 18;

    private PlotStyle() {}

    /** Returns the color of a series by its number, from 0. */
    public static Color color(int index) {
        return new Color(COLORS[index % COLORS.length]);
    }

    static Shape shape(int index) {
        return SHAPES[(index + index / COLORS.length) % SHAPES.length];
    }

    /** Returns the stroke of a line by its number, from 0. */
    static BasicStroke lineStroke(int index) {
        return stroke(LINE_WIDTH, DASHES[index % DASHES.length]);
    }

    /** Returns a stroke with these dashes, or a solid one if there are none. */
    static BasicStroke stroke(float width, float... dashes) {
        return new BasicStroke(
                width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes.length == 0 ? null : dashes, 0);
    }

    /** Returns a text as print has it: the micro sign, minus signs and exponents of what a terminal shows in ASCII. */
    public static String typeset(String text) {
        String signs = text.replaceAll("(?<!\\p{L})um(?!\\p{L})", "\u00b5m")
                .replaceAll("(?<=/ |\\d |\\d)us\\b", "\u00b5s")
                .replaceAll("(?<![\\w.])1e(-?\\d)", "10^$1")
                .replace("+-", "\u00b1")
                .replaceAll("(?<=[\\dm]) x (?=\\d)", " \u00d7 ")
                .replaceAll("(?<![\\p{L}\\p{N}_.)^-])-(?=\\d)|(?<=\\de)-(?=\\d)", "\u2212");
        return EXPONENT.matcher(signs)
                .replaceAll(exponent -> exponent.group(1)
                        .chars()
                        .mapToObj(sign -> SUPERSCRIPTS.substring(RAISED.indexOf(sign), RAISED.indexOf(sign) + 1))
                        .collect(Collectors.joining()));
    }

    static ValueAxis horizontal(Plot.Axis description) {
        return axis(description, new RectangleInsets(4, 10, 2, 10));
    }

    static ValueAxis upright(Plot.Axis description) {
        return axis(description, new RectangleInsets(3, 12, 3, 12));
    }

    private static ValueAxis axis(Plot.Axis description, RectangleInsets labelMargins) {
        ValueAxis axis;
        if (description.scale() == Plot.Scale.LINEAR) {
            NumberAxis linear = new LinearAxis(typeset(description.label()));
            linear.setAutoRangeIncludesZero(false);
            linear.setAutoRangeStickyZero(false);
            linear.setNumberFormatOverride(NUMBERS);
            axis = linear;
        } else {
            LogAxis logarithmic = new PowerAxis(typeset(description.label()));
            logarithmic.setNumberFormatOverride(POWERS);
            axis = logarithmic;
        }
        axis.setLabelFont(LABEL_FONT);
        axis.setLabelPaint(INK);
        axis.setLabelInsets(new RectangleInsets(4, 4, 4, 4));
        axis.setTickMarkStroke(OUTLINE_STROKE);
        axis.setTickLabelFont(LABEL_FONT);
        axis.setTickLabelPaint(INK);
        axis.setTickLabelInsets(labelMargins);
        axis.setTickMarkPaint(INK);
        axis.setTickMarkOutsideLength(8);
        axis.setAxisLineVisible(false);
        return axis;
    }

    /** Axis whose labels are as far apart as their own widths demand; JFreeChart measures those of the range's ends, which have more digits. */
    private static final class LinearAxis extends NumberAxis {
        private static final long serialVersionUID = 1;

        LinearAxis(String label) {
            super(label);
        }

        @Override
        protected double estimateMaximumTickLabelWidth(Graphics2D graphics, TickUnit unit) {
            double step = unit.getSize();
            double widest = DoubleStream.of(
                            step, Math.ceil(getLowerBound() / step) * step, Math.floor(getUpperBound() / step) * step)
                    .mapToObj(NUMBERS::format)
                    .mapToDouble(label -> graphics.getFontMetrics(getTickLabelFont())
                            .getStringBounds(label, graphics)
                            .getWidth())
                    .max()
                    .orElseThrow();
            return widest
                    + getTickLabelInsets().getLeft()
                    + getTickLabelInsets().getRight();
        }
    }

    /** Axis whose labels are centered on their ticks as those of linear axes; JFreeChart centers attributed labels a few pixels off. */
    private static final class PowerAxis extends LogAxis {
        private static final long serialVersionUID = 1;

        PowerAxis(String label) {
            super(label);
        }

        @Override
        @SuppressWarnings({"rawtypes", "unchecked"}) // as JFreeChart declares it
        public List refreshTicks(Graphics2D graphics, AxisState state, Rectangle2D area, RectangleEdge edge) {
            List<ValueTick> ticks = super.refreshTicks(graphics, state, area, edge);
            return ticks.stream().map(this::plain).toList();
        }

        private ValueTick plain(ValueTick tick) {
            boolean isLabeled = tick instanceof LogTick attributed && attributed.getAttributedLabel() != null;
            return new NumberTick(
                    tick.getTickType(),
                    tick.getValue(),
                    isLabeled ? getNumberFormatOverride().format(tick.getValue()) : "",
                    tick.getTextAnchor(),
                    tick.getRotationAnchor(),
                    0);
        }
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
        plot.setOutlineStroke(OUTLINE_STROKE);
        plot.setDomainGridlinePaint(GRID);
        plot.setRangeGridlinePaint(GRID);
        plot.setDomainGridlineStroke(new BasicStroke(1.5f));
        plot.setRangeGridlineStroke(new BasicStroke(1.5f));
        plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
        return plot;
    }

    static JFreeChart chart(String title, XYPlot plot) {
        JFreeChart chart = new JFreeChart(typeset(title), PlotFont.with(TITLE_FONT, title), plot, false);
        chart.setBackgroundPaint(Color.WHITE);
        chart.getTitle().setPaint(INK);
        chart.getTitle().setMargin(0, 0, 10, 0);
        chart.setPadding(new RectangleInsets(MARGIN, MARGIN, MARGIN, MARGIN));
        return chart;
    }

    static Drawing drawing(JFreeChart chart, int width, int height, ChartRenderingInfo info) {
        return new Drawing(
                width, height, graphics -> chart.draw(graphics, new Rectangle2D.Double(0, 0, width, height), info));
    }

    static LegendTitle legend(XYPlot plot, String names) {
        LegendTitle legend = new LegendTitle(plot);
        legend.setPosition(RectangleEdge.BOTTOM);
        legend.setItemFont(PlotFont.with(LABEL_FONT, names));
        legend.setItemPaint(INK);
        legend.setFrame(BlockBorder.NONE);
        legend.setItemLabelPadding(new RectangleInsets(4, 4, 4, 20));
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
        return typesetting(value -> {
            int exponent = (int) Math.floor(Math.log10(value) + 1e-9);
            double mantissa = Math.rint(100 * value / Math.pow(10, exponent)) / 100;
            String power = mantissa == 1 ? "" : NUMBERS.format(mantissa) + "\u00b7";
            return Math.abs(exponent) < 3 ? NUMBERS.format(value) : power + "10^" + exponent;
        });
    }

    private static DecimalFormatSymbols symbols() {
        DecimalFormatSymbols symbols = DecimalFormatSymbols.getInstance(Locale.ROOT);
        symbols.setMinusSign('\u2212');
        return symbols;
    }

    private static NumberFormat typesetting(DoubleFunction<String> format) {
        return new NumberFormat() {
            @Override
            public StringBuffer format(double number, StringBuffer result, FieldPosition position) {
                return result.append(typeset(format.apply(number)));
            }

            @Override
            public StringBuffer format(long number, StringBuffer result, FieldPosition position) {
                return format((double) number, result, position);
            }

            @Override
            public Number parse(String source, ParsePosition position) {
                throw new UnsupportedOperationException("labels are not read");
            }
        };
    }
}
