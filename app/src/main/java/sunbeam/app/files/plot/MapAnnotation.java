package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jfree.chart.text.TextBlock;
import sunbeam.precompute.optics.Direction;

/** Annotates a BRDF map. Marks differ in form and in colors that color-blind people can distinguish, on any color by dark rims. */
public final class MapAnnotation {
    private static final int[] RINGS_DEGREES = {15, 30, 45, 60, 75};
    // Orange and sky blue of Okabe and Ito (see PlotStyle).
    private static final Color LIGHT = new Color(0xE69F00);
    private static final Color MIRROR = new Color(0x56B4E9);
    private static final Color RING = new Color(255, 255, 255, 110);
    private static final Color RING_RIM = new Color(0, 0, 0, 110);
    private static final int SMALLEST_FONT = 9;

    // Width of the margin around the map, in sizes of the font.
    private static final double MARGIN = 2.5;

    private final BufferedImage map;
    private final Direction light;
    private final String caption;
    private final int size;
    private final int margin;
    private final Font font;

    /**
     * @param map square picture of the map, opaque inside the disc; the light is in the tangent frame
     * @param width printed width in meters, at which text has its size
     */
    public MapAnnotation(BufferedImage map, Direction light, List<String> caption, double width) {
        this.map = map;
        this.light = light;
        this.size = map.getWidth();
        double share = Drawing.TEXT_POINTS / 72 * 0.0254 / width;
        this.font = PlotFont.plain((float) Math.max(
                SMALLEST_FONT, Math.ceil(size * share / Math.max(0.5, 1 - 2 * MARGIN * share))));
        this.margin = (int) (MARGIN * font.getSize());
        this.caption = String.join("\n", caption)
                + "\ncircle: light; cross: mirror direction; rings: every 15\u00b0 from the normal";
    }

    public Drawing draw() {
        TextBlock text = Sheet.block(caption, font, size + margin);
        int below = Sheet.height(text) + font.getSize();
        return new Drawing(size + 2 * margin, size + 2 * margin + below, graphics -> {
            graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
            graphics.setFont(font);
            graphics.drawImage(map, margin, margin, null);
            rings(graphics);
            marks(graphics);
            Sheet.draw(text, graphics, margin / 2, size + 2 * margin);
        });
    }

    private double column(double x) {
        return margin + 0.5 * size * (1 + x);
    }

    private double row(double y) {
        return margin + 0.5 * size * (1 - y);
    }

    private Shape circle(double x, double y, double radius) {
        return new Ellipse2D.Double(column(x) - radius, row(y) - radius, 2 * radius, 2 * radius);
    }

    private void rings(Graphics2D graphics) {
        float thin = Math.max(1, size / 512f);
        float[] dashes = {4 * thin, 4 * thin};
        // Labels lie upwards and to the left, clear of orders along the axes and of most lights' planes.
        double slant = Math.sqrt(0.5);
        for (int degrees : RINGS_DEGREES) {
            double radius = Math.sin(Math.toRadians(degrees));
            for (boolean rim : new boolean[] {false, true}) {
                graphics.setStroke(new BasicStroke(
                        thin, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, rim ? dashes[0] : 0));
                graphics.setColor(rim ? RING_RIM : RING);
                graphics.draw(circle(0, 0, 0.5 * size * radius));
            }
            if (degrees % 30 == 0) {
                Shape label = centered(graphics, degrees + "\u00b0", -slant * radius, slant * radius);
                rimmed(graphics, label, 0, Color.WHITE);
                graphics.fill(label);
            }
        }
        graphics.setStroke(new BasicStroke(2 * thin));
        graphics.setColor(PlotStyle.INK);
        graphics.draw(circle(0, 0, 0.5 * size));
        double beyond = 1 + 2.0 * 1.4 * font.getSize() / size;
        for (int degrees = 0; degrees < 360; degrees += 90) {
            double angle = Math.toRadians(degrees);
            graphics.fill(centered(graphics, degrees + "\u00b0", beyond * Math.cos(angle), beyond * Math.sin(angle)));
        }
    }

    private Shape centered(Graphics2D graphics, String text, double x, double y) {
        Rectangle2D bounds =
                font.createGlyphVector(graphics.getFontRenderContext(), text).getVisualBounds();
        return font.createGlyphVector(graphics.getFontRenderContext(), text)
                .getOutline((float) (column(x) - bounds.getCenterX()), (float) (row(y) - bounds.getCenterY()));
    }

    private void marks(Graphics2D graphics) {
        double radius = 0.6 * font.getSize();
        // The cross is wider than the ring of the light, so that both are visible if the light comes from the normal.
        double reach = 1.4 * radius;
        double x = column(-light.x());
        double y = row(-light.y());
        Path2D cross = new Path2D.Double();
        cross.moveTo(x - reach, y - reach);
        cross.lineTo(x + reach, y + reach);
        cross.moveTo(x - reach, y + reach);
        cross.lineTo(x + reach, y - reach);
        float width = Math.max(1.5f, font.getSize() / 6f);
        rimmed(graphics, cross, width, MIRROR);
        rimmed(graphics, circle(light.x(), light.y(), radius), width, LIGHT);
    }

    /** Draws a line of a width, in a color with a dark rim; a width of 0 draws the rim alone and sets the color. */
    private static void rimmed(Graphics2D graphics, Shape shape, float width, Color color) {
        graphics.setStroke(new BasicStroke(Math.max(3, 2 * width), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.setColor(Color.BLACK);
        graphics.draw(shape);
        graphics.setColor(color);
        if (width > 0) {
            graphics.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            graphics.draw(shape);
        }
    }
}
