package sunbeam.app.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Map;

/**
 * A matrix of values in colour over two axes, with a colour bar, curves and marks on top, in the look of {@link Plot}
 * and drawn without a display.
 */
public final class HeatMap {
    // A strip thinner than this is drawn broader than it is.
    private static final double THINNEST = 10;
    static final int TITLE_HEIGHT = 48;
    private static final int LEFT = 92;
    private static final int BOTTOM = 66;
    private static final int RIGHT = 118;

    private final Frame frame;
    private final Values values;
    private final HeatMapOverlays overlays = new HeatMapOverlays();

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

    public HeatMap(Frame frame, Values values) {
        this.frame = frame;
        this.values = values;
    }

    /** Adds a curve with an entry in the legend; points that are NaN or outside the axes interrupt it. */
    public HeatMap curve(String name, double[] x, double[] y, int rgb, boolean dashed) {
        overlays.curve(name, x, y, new Color(rgb), dashed);
        return this;
    }

    /** Adds a ring around a point with a label beside it. */
    public HeatMap mark(String label, double x, double y) {
        overlays.mark(label, x, y);
        return this;
    }

    /** Adds a bar of that length along x, in the lower left corner. */
    public HeatMap scaleBar(String label, double length) {
        overlays.scaleBar(label, length);
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
            PlotArea area = area();
            drawCells(graphics, area);
            overlays.draw(graphics, area);
            HeatMapAxes axes = new HeatMapAxes(graphics, area);
            axes.drawAxes(frame);
            axes.drawBar(values.colors());
            overlays.drawLegend(graphics, area, new Color(values.colors().map().at(0.2)));
        } finally {
            graphics.dispose();
        }
        return image;
    }

    private PlotArea area() {
        int bottom = BOTTOM + overlays.legendHeight();
        double width = frame.width() - LEFT - RIGHT;
        double height = frame.height() - TITLE_HEIGHT - bottom;
        double left = LEFT;
        double top = TITLE_HEIGHT;
        double extentX = values.xRange()[1] - values.xRange()[0];
        double extentY = values.yRange()[1] - values.yRange()[0];
        boolean drawable = extentX < THINNEST * extentY && extentY < THINNEST * extentX;
        if (frame.equalScales() && drawable) {
            double scale = Math.min(width / extentX, height / extentY);
            left += 0.5 * (width - scale * extentX);
            top += 0.5 * (height - scale * extentY);
            width = scale * extentX;
            height = scale * extentY;
        }
        return new PlotArea(new Rectangle2D.Double(left, top, width, height), values.xRange(), values.yRange());
    }

    private int cells(int axis) {
        return axis == 0 ? values.rows()[0].length : values.rows().length;
    }

    private void drawCells(Graphics2D graphics, PlotArea area) {
        int width = Math.max(1, (int) Math.round(area.rectangle().getWidth()));
        int height = Math.max(1, (int) Math.round(area.rectangle().getHeight()));
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
        graphics.drawImage(
                cells,
                (int) Math.round(area.rectangle().getX()),
                (int) Math.round(area.rectangle().getY()),
                null);
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
}
