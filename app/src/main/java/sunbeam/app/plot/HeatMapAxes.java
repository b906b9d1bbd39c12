package sunbeam.app.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;

/** What stands around the matrix of a {@link HeatMap}: border, ticks, titles and the colour bar. */
final class HeatMapAxes {
    private static final int TICKS = 8;
    private static final int TICK_LENGTH = 5;
    private static final int BAR_GAP = 18;
    private static final int BAR_WIDTH = 18;

    private final Graphics2D graphics;
    private final PlotArea area;

    HeatMapAxes(Graphics2D graphics, PlotArea area) {
        this.graphics = graphics;
        this.area = area;
    }

    /** The border, ticks and titles. */
    void drawAxes(HeatMap.Frame frame) {
        graphics.setColor(PlotStyle.INK);
        graphics.setStroke(new BasicStroke(1));
        graphics.draw(area.rectangle());
        graphics.setFont(PlotStyle.TICK_FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        Ticks alongX = Ticks.between(area.xRange()[0], area.xRange()[1], TICKS);
        for (int i = 0; i < alongX.values().length; i++) {
            int x = (int) Math.round(area.pixelX(alongX.values()[i]));
            int y = (int) Math.round(area.rectangle().getMaxY());
            graphics.drawLine(x, y, x, y + TICK_LENGTH);
            String label = alongX.label(i);
            graphics.drawString(label, x - metrics.stringWidth(label) / 2, y + TICK_LENGTH + metrics.getAscent() + 2);
        }
        Ticks alongY = Ticks.between(area.yRange()[0], area.yRange()[1], TICKS);
        for (int i = 0; i < alongY.values().length; i++) {
            int x = (int) Math.round(area.rectangle().getX());
            int y = (int) Math.round(area.pixelY(alongY.values()[i]));
            graphics.drawLine(x - TICK_LENGTH, y, x, y);
            String label = alongY.label(i);
            graphics.drawString(
                    label, x - TICK_LENGTH - 4 - metrics.stringWidth(label), y + metrics.getAscent() / 2 - 2);
        }
        drawTitles(frame);
    }

    private void drawTitles(HeatMap.Frame frame) {
        graphics.setFont(PlotStyle.TITLE_FONT);
        centred(
                graphics,
                frame.title(),
                area.rectangle().getCenterX(),
                0.68 * HeatMap.TITLE_HEIGHT + area.rectangle().getY() - HeatMap.TITLE_HEIGHT);
        graphics.setFont(PlotStyle.LABEL_FONT);
        centred(
                graphics,
                frame.xLabel(),
                area.rectangle().getCenterX(),
                area.rectangle().getMaxY() + 48);
        upright(
                graphics,
                frame.yLabel(),
                area.rectangle().getX() - 62,
                area.rectangle().getCenterY());
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

    /** The colours and their values, right of the matrix. */
    void drawBar(HeatMap.Colors colors) {
        int x = (int) Math.round(area.rectangle().getMaxX()) + BAR_GAP;
        int top = (int) Math.round(area.rectangle().getY());
        int height = (int) Math.round(area.rectangle().getHeight());
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
        upright(graphics, colors.label(), x + BAR_WIDTH + 70, area.rectangle().getCenterY());
    }
}
