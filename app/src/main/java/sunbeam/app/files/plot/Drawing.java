package sunbeam.app.files.plot;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;

/** Picture that draws itself on white, into a bitmap or a file of vectors; width and height are in pixels of the bitmap. */
public record Drawing(int width, int height, Consumer<Graphics2D> content) {
    /** Pixels of a plot per meter of print, 300 an inch. */
    static final double PIXELS_PER_METER = 300 / 0.0254;
    /** Pixels of a typographic point at that resolution. */
    static final float POINT = 300 / 72f;
    /** Size of text, points; printed 85 mm wide, a picture of the standard width has text of 6 points. */
    static final double TEXT_POINTS = 8;

    /** Width in meters for which type and strokes of a picture are made, unless the user names another. */
    public static final double STANDARD_WIDTH = 0.085 * TEXT_POINTS / 6;

    /** The standard width in pixels. */
    public static final int COLUMN = pixels(STANDARD_WIDTH);

    /** Returns the pixels of a plot of this width in meters. */
    public static int pixels(double width) {
        return (int) Math.round(width * PIXELS_PER_METER);
    }

    public static Drawing of(BufferedImage image) {
        return new Drawing(image.getWidth(), image.getHeight(), graphics -> graphics.drawImage(image, 0, 0, null));
    }

    /** Puts drawings below one another, aligned at the left. */
    public static Drawing column(int gap, Drawing... drawings) {
        return joined(gap, 0, 1, drawings);
    }

    /** Lays drawings side by side, tops aligned. */
    public static Drawing row(int gap, Drawing... drawings) {
        return joined(gap, 1, 0, drawings);
    }

    private static Drawing joined(int gap, int right, int down, Drawing... drawings) {
        Rectangle all = new Rectangle();
        Point[] corners = new Point[drawings.length];
        for (int i = 0; i < drawings.length; i++) {
            int step = i == 0 ? 0 : gap;
            corners[i] = new Point(right * (all.width + step), down * (all.height + step));
            all.add(new Rectangle(corners[i], new Dimension(drawings[i].width, drawings[i].height)));
        }
        return new Drawing(all.width, all.height, graphics -> {
            for (int i = 0; i < drawings.length; i++) {
                drawings[i].drawAt(graphics, corners[i].x, corners[i].y);
            }
        });
    }

    public void drawAt(Graphics2D graphics, int x, int y) {
        Graphics2D part = (Graphics2D) graphics.create();
        part.translate(x, y);
        content.accept(part);
        part.dispose();
    }

    /** Returns the bitmap, opaque. */
    public BufferedImage rasterize() {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        smooth(graphics);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, width, height);
        content.accept(graphics);
        graphics.dispose();
        return image;
    }

    static void smooth(Graphics2D graphics) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }
}
