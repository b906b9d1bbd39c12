package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import org.jfree.chart.annotations.AbstractXYAnnotation;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleEdge;

/** What is painted by hand inside a plot's area. */
final class Overlay extends AbstractXYAnnotation {
    private static final Color SHADE = new Color(0, 0, 0, 150);

    private final transient Painter painter;

    /** Paints in pixels. */
    interface Painter {
        void paint(Graphics2D graphics, Rectangle2D area, ValueAxis alongX, ValueAxis alongY);
    }

    Overlay(Painter painter) {
        this.painter = painter;
    }

    /** A ring around a point with a label beside it, which stays inside. */
    static Overlay ring(String label, double atX, double atY) {
        return new Overlay((graphics, area, alongX, alongY) -> {
            double x = alongX.valueToJava2D(atX, area, RectangleEdge.BOTTOM);
            double y = alongY.valueToJava2D(atY, area, RectangleEdge.LEFT);
            graphics.setStroke(new BasicStroke(2));
            graphics.setColor(PlotStyle.MARK);
            graphics.draw(new Ellipse2D.Double(x - 8, y - 8, 16, 16));
            graphics.setFont(PlotStyle.TICK_FONT);
            FontMetrics metrics = graphics.getFontMetrics();
            int width = metrics.stringWidth(label);
            double textX = Math.min(x + 12, area.getMaxX() - width - 4);
            double textY = y + (textX < x + 12 ? -14 : 5);
            graphics.setColor(SHADE);
            graphics.fill(
                    new Rectangle2D.Double(textX - 3, textY - metrics.getAscent(), width + 6.0, metrics.getHeight()));
            graphics.setColor(Color.WHITE);
            graphics.drawString(label, (float) textX, (float) textY);
        });
    }

    /** A bar of a length along x, in the lower left corner. */
    static Overlay scaleBar(String label, double length) {
        return new Overlay((graphics, area, alongX, alongY) -> {
            graphics.setFont(PlotStyle.LABEL_FONT);
            int textWidth = graphics.getFontMetrics().stringWidth(label);
            int pixels = (int) Math.round(alongX.lengthToJava2D(length, area, RectangleEdge.BOTTOM));
            int x = (int) Math.round(area.getX()) + 16;
            int y = (int) Math.round(area.getMaxY()) - 20;
            graphics.setColor(SHADE);
            graphics.fillRect(x - 8, y - 26, Math.max(pixels, textWidth) + 16, 40);
            graphics.setColor(Color.WHITE);
            graphics.fillRect(x, y, pixels, 5);
            graphics.drawString(label, x + Math.max(0, (pixels - textWidth) / 2), y - 6);
        });
    }

    @Override
    public void draw(
            Graphics2D graphics,
            XYPlot plot,
            Rectangle2D area,
            ValueAxis alongX,
            ValueAxis alongY,
            int renderer,
            PlotRenderingInfo info) {
        painter.paint(graphics, area, alongX, alongY);
    }
}
