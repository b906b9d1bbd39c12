package sunbeam.app.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A matrix of values in colour over two axes, with a colour bar, curves and marks on top, in the look of {@link Plot}
 * and drawn without a display.
 */
public final class HeatMap {
    private static final int TICKS = 8;
    // A strip thinner than this is drawn broader than it is.
    private static final double THINNEST = 10;
    private static final int TICK_LENGTH = 5;
    private static final int TITLE_HEIGHT = 48;
    private static final int LEFT = 92;
    private static final int BOTTOM = 66;
    private static final int RIGHT = 118;
    private static final int BAR_GAP = 18;
    private static final int BAR_WIDTH = 18;
    private static final int LEGEND_HEIGHT = 28;

    private final Frame frame;
    private final Values values;
    private final List<Curve> curves = new ArrayList<>();
    private final List<Mark> marks = new ArrayList<>();
    private ScaleBar scaleBar;

    /**
     * What stands around the matrix.
     *
     * @param width of the picture, pixels
     * @param height of the picture, pixels
     * @param equalScales whether a unit is as long along y as along x, unless the matrix is a thin strip
     */
    public record Frame(String title, String xLabel, String yLabel, int width, int height, boolean equalScales) {}

    /**
     * The matrix.
     *
     * @param rows {@code [row][column]}, row 0 at the lowest y
     * @param xRange where the first column begins and the last one ends
     * @param yRange where the first row begins and the last one ends
     * @param colors from the lowest to the highest value
     * @param reduction what a pixel shows that holds several values
     */
    public record Values(double[][] rows, double[] xRange, double[] yRange, Colors colors, Reduction reduction) {

        /** Ends of a range of cells with these centres in even steps, at least two. */
        public static double[] around(double[] centres) {
            double half = 0.5 * (centres[centres.length - 1] - centres[0]) / (centres.length - 1);
            return new double[] {centres[0] - half, centres[centres.length - 1] + half};
        }
    }

    /** What a pixel shows that holds several values. */
    public enum Reduction {
        /** The largest, lest a thin ridge or a peak gets lost. */
        LARGEST,
        /** The one in the middle: a picture keeps its grain. */
        MIDDLE
    }

    /**
     * How values become colours.
     *
     * @param low value of the first colour; positive where logarithmic
     * @param high value of the last colour, above low
     */
    public record Colors(String label, double low, double high, Plot.Scale scale, ColorMap map) {
        double position(double value) {
            return scale == Plot.Scale.LINEAR
                    ? (value - low) / (high - low)
                    : Math.log(Math.max(value, low) / low) / Math.log(high / low);
        }
    }

    private record Curve(String name, double[] x, double[] y, Color color, boolean dashed) {}

    private record Mark(String label, double x, double y) {}

    private record ScaleBar(String label, double length) {}

    public HeatMap(Frame frame, Values values) {
        this.frame = frame;
        this.values = values;
    }

    /** Adds a curve with an entry in the legend; points that are NaN or outside the axes interrupt it. */
    public HeatMap curve(String name, double[] x, double[] y, int rgb, boolean dashed) {
        curves.add(new Curve(name, x, y, new Color(rgb), dashed));
        return this;
    }

    /** Adds a ring around a point with a label beside it. */
    public HeatMap mark(String label, double x, double y) {
        marks.add(new Mark(label, x, y));
        return this;
    }

    /** Adds a bar of that length along x, in the lower left corner. */
    public HeatMap scaleBar(String label, double length) {
        scaleBar = new ScaleBar(label, length);
        return this;
    }

    /** The picture. */
    public BufferedImage draw() {
        BufferedImage image = new BufferedImage(frame.width(), frame.height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        try {
            graphics.setRenderingHints(Map.of(
                    RenderingHints.KEY_ANTIALIASING,
                    RenderingHints.VALUE_ANTIALIAS_ON,
                    RenderingHints.KEY_TEXT_ANTIALIASING,
                    RenderingHints.VALUE_TEXT_ANTIALIAS_ON));
            graphics.setColor(Color.WHITE);
            graphics.fillRect(0, 0, frame.width(), frame.height());
            Rectangle2D area = area();
            drawCells(graphics, area);
            drawCurves(graphics, area);
            drawMarks(graphics, area);
            drawScaleBar(graphics, area);
            drawAxes(graphics, area);
            drawBar(graphics, area);
            drawLegend(graphics, area);
        } finally {
            graphics.dispose();
        }
        return image;
    }

    private Rectangle2D area() {
        int bottom = BOTTOM + (curves.isEmpty() ? 0 : LEGEND_HEIGHT);
        double width = frame.width() - LEFT - RIGHT;
        double height = frame.height() - TITLE_HEIGHT - bottom;
        double left = LEFT;
        double top = TITLE_HEIGHT;
        boolean drawable = extent(0) < THINNEST * extent(1) && extent(1) < THINNEST * extent(0);
        if (frame.equalScales() && drawable) {
            double scale = Math.min(width / extent(0), height / extent(1));
            left += 0.5 * (width - scale * extent(0));
            top += 0.5 * (height - scale * extent(1));
            width = scale * extent(0);
            height = scale * extent(1);
        }
        return new Rectangle2D.Double(left, top, width, height);
    }

    private int cells(int axis) {
        return axis == 0 ? values.rows()[0].length : values.rows().length;
    }

    private double extent(int axis) {
        return axis == 0 ? values.xRange()[1] - values.xRange()[0] : values.yRange()[1] - values.yRange()[0];
    }

    private double low(int axis) {
        return axis == 0 ? values.xRange()[0] : values.yRange()[0];
    }

    private double pixelX(Rectangle2D area, double x) {
        return area.getX() + (x - low(0)) / extent(0) * area.getWidth();
    }

    private double pixelY(Rectangle2D area, double y) {
        return area.getMaxY() - (y - low(1)) / extent(1) * area.getHeight();
    }

    private void drawCells(Graphics2D graphics, Rectangle2D area) {
        int width = Math.max(1, (int) Math.round(area.getWidth()));
        int height = Math.max(1, (int) Math.round(area.getHeight()));
        BufferedImage cells = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int[] columns = edges(width, cells(0));
        int[] rows = edges(height, cells(1));
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double value = values.reduction() == Reduction.LARGEST
                        ? largest(columns, x, rows, height - 1 - y)
                        : values.rows()[middle(rows, height - 1 - y)][middle(columns, x)];
                cells.setRGB(x, y, values.colors().map().at(values.colors().position(value)));
            }
        }
        graphics.drawImage(cells, (int) Math.round(area.getX()), (int) Math.round(area.getY()), null);
    }

    private static int middle(int[] edges, int pixel) {
        return Math.min(edges[edges.length - 1] - 1, (edges[pixel] + edges[pixel + 1]) / 2);
    }

    private static int[] edges(int pixels, int cells) {
        int[] edges = new int[pixels + 1];
        for (int i = 0; i <= pixels; i++) {
            edges[i] = (int) ((long) i * cells / pixels);
        }
        return edges;
    }

    private double largest(int[] columns, int x, int[] rows, int y) {
        double largest = Double.NEGATIVE_INFINITY;
        for (int row = rows[y]; row < Math.max(rows[y] + 1, rows[y + 1]); row++) {
            for (int column = columns[x]; column < Math.max(columns[x] + 1, columns[x + 1]); column++) {
                largest = Math.max(largest, values.rows()[row][column]);
            }
        }
        return largest;
    }

    private void drawCurves(Graphics2D graphics, Rectangle2D area) {
        Shape clip = graphics.getClip();
        graphics.clip(area);
        for (Curve curve : curves) {
            Path2D path = new Path2D.Double();
            boolean drawing = false;
            for (int i = 0; i < curve.x().length; i++) {
                boolean there = Double.isFinite(curve.x()[i]) && Double.isFinite(curve.y()[i]);
                if (there && drawing) {
                    path.lineTo(pixelX(area, curve.x()[i]), pixelY(area, curve.y()[i]));
                } else if (there) {
                    path.moveTo(pixelX(area, curve.x()[i]), pixelY(area, curve.y()[i]));
                }
                drawing = there;
            }
            graphics.setColor(curve.color());
            graphics.setStroke(stroke(curve));
            graphics.draw(path);
        }
        graphics.setClip(clip);
    }

    private static BasicStroke stroke(Curve curve) {
        float[] dashes = {10, 8};
        return curve.dashed()
                ? new BasicStroke(2.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0)
                : new BasicStroke(2.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);
    }

    private void drawMarks(Graphics2D graphics, Rectangle2D area) {
        Shape clip = graphics.getClip();
        graphics.clip(area);
        graphics.setFont(PlotStyle.TICK_FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        for (Mark mark : marks) {
            double x = pixelX(area, mark.x());
            double y = pixelY(area, mark.y());
            graphics.setStroke(new BasicStroke(2));
            graphics.setColor(PlotStyle.MARK);
            graphics.draw(new Ellipse2D.Double(x - 8, y - 8, 16, 16));
            double textX = Math.min(x + 12, area.getMaxX() - metrics.stringWidth(mark.label()) - 4);
            float textY = (float) (y + (textX < x + 12 ? -14 : 5));
            graphics.setColor(Color.WHITE);
            graphics.drawString(mark.label(), (float) textX, textY);
        }
        graphics.setClip(clip);
    }

    private void drawScaleBar(Graphics2D graphics, Rectangle2D area) {
        if (scaleBar == null) {
            return;
        }
        graphics.setFont(PlotStyle.LABEL_FONT);
        int textWidth = graphics.getFontMetrics().stringWidth(scaleBar.label());
        int length = (int) Math.round(scaleBar.length() / extent(0) * area.getWidth());
        int x = (int) Math.round(area.getX()) + 16;
        int y = (int) Math.round(area.getMaxY()) - 20;
        graphics.setColor(new Color(0, 0, 0, 170));
        graphics.fillRect(x - 8, y - 26, Math.max(length, textWidth) + 16, 40);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(x, y, length, 5);
        graphics.drawString(scaleBar.label(), x + Math.max(0, (length - textWidth) / 2), y - 6);
    }

    private void drawAxes(Graphics2D graphics, Rectangle2D area) {
        graphics.setColor(PlotStyle.INK);
        graphics.setStroke(new BasicStroke(1));
        graphics.draw(area);
        graphics.setFont(PlotStyle.TICK_FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        Ticks alongX = Ticks.between(low(0), low(0) + extent(0), TICKS);
        for (int i = 0; i < alongX.values().length; i++) {
            int x = (int) Math.round(pixelX(area, alongX.values()[i]));
            int y = (int) Math.round(area.getMaxY());
            graphics.drawLine(x, y, x, y + TICK_LENGTH);
            String label = alongX.label(i);
            graphics.drawString(label, x - metrics.stringWidth(label) / 2, y + TICK_LENGTH + metrics.getAscent() + 2);
        }
        Ticks alongY = Ticks.between(low(1), low(1) + extent(1), TICKS);
        for (int i = 0; i < alongY.values().length; i++) {
            int x = (int) Math.round(area.getX());
            int y = (int) Math.round(pixelY(area, alongY.values()[i]));
            graphics.drawLine(x - TICK_LENGTH, y, x, y);
            String label = alongY.label(i);
            graphics.drawString(
                    label, x - TICK_LENGTH - 4 - metrics.stringWidth(label), y + metrics.getAscent() / 2 - 2);
        }
        drawTitles(graphics, area);
    }

    private void drawTitles(Graphics2D graphics, Rectangle2D area) {
        graphics.setFont(PlotStyle.TITLE_FONT);
        centred(graphics, frame.title(), area.getCenterX(), 0.68 * TITLE_HEIGHT + area.getY() - TITLE_HEIGHT);
        graphics.setFont(PlotStyle.LABEL_FONT);
        centred(graphics, frame.xLabel(), area.getCenterX(), area.getMaxY() + 48);
        upright(graphics, frame.yLabel(), area.getX() - 62, area.getCenterY());
    }

    private static void centred(Graphics2D graphics, String text, double x, double y) {
        graphics.drawString(text, (float) (x - 0.5 * graphics.getFontMetrics().stringWidth(text)), (float) y);
    }

    private static void upright(Graphics2D graphics, String text, double x, double y) {
        AffineTransform before = graphics.getTransform();
        graphics.translate(x, y);
        graphics.rotate(-Math.PI / 2);
        centred(graphics, text, 0, 0);
        graphics.setTransform(before);
    }

    private void drawBar(Graphics2D graphics, Rectangle2D area) {
        Colors colors = values.colors();
        int x = (int) Math.round(area.getMaxX()) + BAR_GAP;
        int top = (int) Math.round(area.getY());
        int height = (int) Math.round(area.getHeight());
        for (int y = 0; y < height; y++) {
            graphics.setColor(new Color(colors.map().at(1 - (y + 0.5) / height)));
            graphics.fillRect(x, top + y, BAR_WIDTH, 1);
        }
        graphics.setColor(PlotStyle.INK);
        graphics.setStroke(new BasicStroke(1));
        graphics.drawRect(x, top, BAR_WIDTH, height);
        boolean linear = colors.scale() == Plot.Scale.LINEAR;
        Ticks ticks = linear
                ? Ticks.between(colors.low(), colors.high(), TICKS)
                : Ticks.powersOfTen(colors.low(), colors.high());
        graphics.setFont(PlotStyle.TICK_FONT);
        for (int i = 0; i < ticks.values().length; i++) {
            double value = ticks.values()[i];
            int y = (int) Math.round(top + height * (1 - colors.position(value)));
            graphics.drawLine(x + BAR_WIDTH, y, x + BAR_WIDTH + TICK_LENGTH, y);
            String label = linear ? ticks.label(i) : PlotStyle.powerOfTen(value);
            graphics.drawString(label, x + BAR_WIDTH + TICK_LENGTH + 3, y + 5);
        }
        graphics.setFont(PlotStyle.LABEL_FONT);
        upright(graphics, colors.label(), x + BAR_WIDTH + 70, area.getCenterY());
    }

    private void drawLegend(Graphics2D graphics, Rectangle2D area) {
        graphics.setFont(PlotStyle.TICK_FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        double x = area.getX();
        int y = (int) Math.round(area.getMaxY()) + 48 + LEGEND_HEIGHT;
        for (Curve curve : curves) {
            int swatch = 40;
            graphics.setColor(new Color(values.colors().map().at(0.2)));
            graphics.fillRect((int) x, y - 14, swatch, 18);
            graphics.setColor(curve.color());
            graphics.setStroke(stroke(curve));
            graphics.drawLine((int) x + 3, y - 5, (int) x + swatch - 3, y - 5);
            graphics.setColor(PlotStyle.INK);
            graphics.drawString(curve.name(), (int) x + swatch + 8, y);
            x += swatch + 8 + metrics.stringWidth(curve.name()) + 30;
        }
    }
}
