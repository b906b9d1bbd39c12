package sunbeam.app.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** What lies on top of a {@link HeatMap}: curves with their legend, marks and a scale bar. */
final class HeatMapOverlays {
    private static final Color SHADE = new Color(0, 0, 0, 150);
    private static final float CURVE_WIDTH = 1.7f;
    private static final int LEGEND_HEIGHT = 28;

    private final List<Curve> curves = new ArrayList<>();
    private final List<Mark> marks = new ArrayList<>();
    private ScaleBar scaleBar;

    private record Curve(String name, double[] x, double[] y, Color color, boolean dashed) {}

    private record Mark(String label, double x, double y) {}

    private record ScaleBar(String label, double length) {}

    void curve(String name, double[] x, double[] y, Color color, boolean dashed) {
        curves.add(new Curve(name, x, y, color, dashed));
    }

    void mark(String label, double x, double y) {
        marks.add(new Mark(label, x, y));
    }

    void scaleBar(String label, double length) {
        scaleBar = new ScaleBar(label, length);
    }

    /** Pixels that the legend takes below the axes. */
    int legendHeight() {
        return curves.isEmpty() ? 0 : LEGEND_HEIGHT;
    }

    void draw(Graphics2D graphics, PlotArea area) {
        drawCurves(graphics, area);
        drawMarks(graphics, area);
        drawScaleBar(graphics, area);
    }

    private void drawCurves(Graphics2D graphics, PlotArea area) {
        Shape clip = graphics.getClip();
        graphics.clip(area.rectangle());
        for (Curve curve : curves) {
            Path2D path = new Path2D.Double();
            boolean drawing = false;
            for (int i = 0; i < curve.x().length; i++) {
                boolean there = Double.isFinite(curve.x()[i]) && Double.isFinite(curve.y()[i]);
                if (there && drawing) {
                    path.lineTo(area.pixelX(curve.x()[i]), area.pixelY(curve.y()[i]));
                } else if (there) {
                    path.moveTo(area.pixelX(curve.x()[i]), area.pixelY(curve.y()[i]));
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
                ? new BasicStroke(CURVE_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0)
                : new BasicStroke(CURVE_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);
    }

    private void drawMarks(Graphics2D graphics, PlotArea area) {
        Shape clip = graphics.getClip();
        graphics.clip(area.rectangle());
        graphics.setFont(PlotStyle.TICK_FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        for (Mark mark : marks) {
            double x = area.pixelX(mark.x());
            double y = area.pixelY(mark.y());
            graphics.setStroke(new BasicStroke(2));
            graphics.setColor(PlotStyle.MARK);
            graphics.draw(new Ellipse2D.Double(x - 8, y - 8, 16, 16));
            double textX = Math.min(x + 12, area.rectangle().getMaxX() - metrics.stringWidth(mark.label()) - 4);
            float textY = (float) (y + (textX < x + 12 ? -14 : 5));
            graphics.setColor(SHADE);
            graphics.fill(new Rectangle2D.Double(
                    textX - 3,
                    textY - metrics.getAscent(),
                    metrics.stringWidth(mark.label()) + 6,
                    metrics.getHeight()));
            graphics.setColor(Color.WHITE);
            graphics.drawString(mark.label(), (float) textX, textY);
        }
        graphics.setClip(clip);
    }

    private void drawScaleBar(Graphics2D graphics, PlotArea area) {
        if (scaleBar == null) {
            return;
        }
        graphics.setFont(PlotStyle.LABEL_FONT);
        int textWidth = graphics.getFontMetrics().stringWidth(scaleBar.label());
        int length = (int) Math.round(area.pixelX(area.xRange()[0] + scaleBar.length())
                - area.rectangle().getX());
        int x = (int) Math.round(area.rectangle().getX()) + 16;
        int y = (int) Math.round(area.rectangle().getMaxY()) - 20;
        graphics.setColor(SHADE);
        graphics.fillRect(x - 8, y - 26, Math.max(length, textWidth) + 16, 40);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(x, y, length, 5);
        graphics.drawString(scaleBar.label(), x + Math.max(0, (length - textWidth) / 2), y - 6);
    }

    /** @param background of the swatches */
    void drawLegend(Graphics2D graphics, PlotArea area, Color background) {
        graphics.setFont(PlotStyle.TICK_FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        double x = area.rectangle().getX();
        int y = (int) Math.round(area.rectangle().getMaxY()) + 48 + LEGEND_HEIGHT;
        for (Curve curve : curves) {
            int swatch = 40;
            graphics.setColor(background);
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
