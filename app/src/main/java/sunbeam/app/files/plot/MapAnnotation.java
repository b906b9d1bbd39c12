package sunbeam.app.files.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.optics.Direction;

/**
 * A BRDF map made ready for print: the circle of the horizon, rings of angles to the normal, azimuths, marks of light and
 * mirror direction, and a caption. Marks differ in form, and in two colors that color-blind people can tell apart; each
 * has a dark rim, so that it is seen on light and on dark.
 */
public final class MapAnnotation {
    private static final int[] RINGS_DEGREES = {15, 30, 45, 60, 75};
    // Okabe and Ito.
    private static final Color LIGHT = new Color(0xE69F00);
    private static final Color MIRROR = new Color(0x56B4E9);
    private static final Color RIM = Color.BLACK;
    private static final Color RING = new Color(255, 255, 255, 110);
    private static final Color RING_RIM = new Color(0, 0, 0, 110);
    private static final int SMALLEST_FONT = 9;

    private final BufferedImage map;
    private final Direction light;
    private final List<String> caption;
    private final int size;
    private final int margin;
    private final Font font;

    /**
     * @param map square, opaque inside the disc
     * @param light towards the light, tangent frame
     * @param caption paragraphs, which are broken into lines
     */
    public MapAnnotation(BufferedImage map, Direction light, List<String> caption) {
        this.map = map;
        this.light = light;
        this.caption = List.copyOf(caption);
        this.size = map.getWidth();
        this.font = new Font(Font.SANS_SERIF, Font.PLAIN, Math.max(SMALLEST_FONT, size / 36));
        this.margin = 3 * font.getSize();
    }

    /** The picture: the map, a margin of three lines around it and the caption below; opaque. */
    public BufferedImage draw() {
        List<String> lines = lines();
        int lineHeight = metrics().getHeight();
        BufferedImage image = new BufferedImage(
                size + 2 * margin, size + 2 * margin + lineHeight * (lines.size() + 3), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        prepare(graphics);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
        graphics.drawImage(map, margin, margin, null);
        rings(graphics);
        azimuths(graphics);
        mark(graphics, mirrorShape(-light.x(), -light.y(), mark()), MIRROR);
        mark(graphics, lightShape(light.x(), light.y(), mark()), LIGHT);
        int baseline = size + 2 * margin + metrics().getAscent();
        for (String line : lines) {
            graphics.setColor(PlotStyle.INK);
            graphics.drawString(line, margin / 2, baseline);
            baseline += lineHeight;
        }
        legend(graphics, baseline + lineHeight / 4);
        graphics.dispose();
        return image;
    }

    private void prepare(Graphics2D graphics) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        graphics.setFont(font);
    }

    private FontMetrics metrics() {
        Graphics2D graphics = map.createGraphics();
        try {
            return graphics.getFontMetrics(font);
        } finally {
            graphics.dispose();
        }
    }

    private double mark() {
        return 0.6 * font.getSize();
    }

    private double column(double x) {
        return margin + 0.5 * size * (1 + x);
    }

    private double row(double y) {
        return margin + 0.5 * size * (1 - y);
    }

    private Shape circle(double radius) {
        return new Ellipse2D.Double(column(-radius), row(radius), size * radius, size * radius);
    }

    private void rings(Graphics2D graphics) {
        float thin = Math.max(1, size / 512f);
        float[] dashes = {4 * thin, 4 * thin};
        for (int degrees : RINGS_DEGREES) {
            Shape ring = circle(Math.sin(Math.toRadians(degrees)));
            graphics.setStroke(new BasicStroke(thin, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0));
            graphics.setColor(RING);
            graphics.draw(ring);
            graphics.setStroke(
                    new BasicStroke(thin, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, dashes[0]));
            graphics.setColor(RING_RIM);
            graphics.draw(ring);
        }
        graphics.setStroke(new BasicStroke(2 * thin));
        graphics.setColor(PlotStyle.INK);
        graphics.draw(circle(1));
        // Upwards and to the left, where neither orders along the axes nor the light's plane of most maps lie.
        double slant = Math.sqrt(0.5);
        for (int degrees : RINGS_DEGREES) {
            double radius = Math.sin(Math.toRadians(degrees));
            if (degrees % 30 == 0) {
                rimmed(graphics, degrees + "\u00b0", column(-slant * radius), row(slant * radius));
            }
        }
    }

    /** Text in white with a dark rim, its middle at a point. */
    private void rimmed(Graphics2D graphics, String text, double x, double y) {
        FontMetrics metrics = graphics.getFontMetrics();
        double left = x - metrics.stringWidth(text) / 2.0;
        double baseline = y + (metrics.getAscent() - metrics.getDescent()) / 2.0;
        Shape outline = font.createGlyphVector(graphics.getFontRenderContext(), text)
                .getOutline((float) left, (float) baseline);
        graphics.setStroke(new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.setColor(RIM);
        graphics.draw(outline);
        graphics.setColor(Color.WHITE);
        graphics.fill(outline);
    }

    private void azimuths(Graphics2D graphics) {
        double beyond = 1 + 2.0 * 1.4 * font.getSize() / size;
        graphics.setColor(PlotStyle.INK);
        for (int degrees = 0; degrees < 360; degrees += 90) {
            double angle = Math.toRadians(degrees);
            String text = degrees + "\u00b0";
            FontMetrics metrics = graphics.getFontMetrics();
            graphics.drawString(
                    text, (float) (column(beyond * Math.cos(angle)) - metrics.stringWidth(text) / 2.0), (float)
                            (row(beyond * Math.sin(angle)) + (metrics.getAscent() - metrics.getDescent()) / 2.0));
        }
    }

    private Shape lightShape(double x, double y, double radius) {
        return new Ellipse2D.Double(column(x) - radius, row(y) - radius, 2 * radius, 2 * radius);
    }

    private Shape mirrorShape(double x, double y, double radius) {
        // Wider than the ring of the light, so that both are seen when the light comes from the normal.
        double reach = 1.4 * radius;
        Path2D cross = new Path2D.Double();
        cross.moveTo(column(x) - reach, row(y) - reach);
        cross.lineTo(column(x) + reach, row(y) + reach);
        cross.moveTo(column(x) - reach, row(y) + reach);
        cross.lineTo(column(x) + reach, row(y) - reach);
        return cross;
    }

    private void mark(Graphics2D graphics, Shape shape, Color color) {
        float width = Math.max(1.5f, font.getSize() / 6f);
        graphics.setStroke(new BasicStroke(2 * width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.setColor(RIM);
        graphics.draw(shape);
        graphics.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.setColor(color);
        graphics.draw(shape);
    }

    private void legend(Graphics2D graphics, int baseline) {
        double middle = baseline - 0.35 * font.getSize();
        double left = margin / 2.0 + mark();
        double y = 1 - 2 * (middle - margin) / size;
        mark(graphics, lightShape(2 * (left - margin) / size - 1, y, mark()), LIGHT);
        left = text(graphics, "light", left + 2 * mark(), baseline) + 5 * mark();
        mark(graphics, mirrorShape(2 * (left - margin) / size - 1, y, mark()), MIRROR);
        left = text(graphics, "mirror direction", left + 2 * mark(), baseline) + 2 * mark();
        String rings = "rings: every 15\u00b0 from the normal";
        if (left + graphics.getFontMetrics().stringWidth(rings) < size + 2 * margin) {
            text(graphics, rings, left, baseline);
        } else {
            text(
                    graphics,
                    rings,
                    margin / 2.0,
                    baseline + graphics.getFontMetrics().getHeight());
        }
    }

    /** Draws and returns where the text ends. */
    private static double text(Graphics2D graphics, String words, double left, double baseline) {
        graphics.setColor(PlotStyle.INK);
        graphics.drawString(words, (float) left, (float) baseline);
        return left + graphics.getFontMetrics().stringWidth(words);
    }

    private List<String> lines() {
        FontMetrics metrics = metrics();
        int width = size + margin;
        List<String> lines = new ArrayList<>();
        for (String paragraph : caption) {
            StringBuilder line = new StringBuilder();
            for (String word : paragraph.split(" ", -1)) {
                String shown = FittedNames.of(word, font, width);
                boolean fits = metrics.stringWidth(line + " " + shown) <= width;
                if (!line.isEmpty() && !fits) {
                    lines.add(line.toString());
                    line.setLength(0);
                }
                line.append(line.isEmpty() ? "" : " ").append(shown);
            }
            lines.add(line.toString());
        }
        return lines;
    }

    /** An exposure as captions tell it. */
    public static String exposureText(double factor) {
        return String.format(Locale.ROOT, "exposure %.4g", factor);
    }
}
