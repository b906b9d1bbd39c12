package sunbeam.app.viewer.picture;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Small labels of one painting: each lies within the bounds and covers no other. A label that finds no free place is left out. */
final class MapLabels {
    private static final double GAP = 4;

    private final Graphics2D graphics;
    private final Rectangle2D bounds;
    private final List<Rectangle2D> taken = new ArrayList<>();

    MapLabels(Graphics2D graphics, Rectangle2D bounds) {
        this.graphics = graphics;
        this.bounds = bounds;
    }

    /** Paints a label beside a point: to the upper right, else upper left, lower right or lower left. Returns its place, or null. */
    Rectangle2D paint(String text, double x, double y) {
        FontMetrics metrics = graphics.getFontMetrics();
        double width = metrics.stringWidth(text) + 1.0;
        double height = metrics.getAscent();
        for (double top : new double[] {y - GAP - height + 2, y + GAP}) {
            for (double left : new double[] {x + GAP, x - GAP - width}) {
                Rectangle2D place = new Rectangle2D.Double(left, top, width, height);
                if (bounds.contains(place) && taken.stream().noneMatch(place::intersects)) {
                    taken.add(place);
                    paintOutlined(text, (float) left, (float) (top + height - 1));
                    return place;
                }
            }
        }
        return null;
    }

    private void paintOutlined(String text, float x, float y) {
        graphics.setColor(Color.BLACK);
        graphics.drawString(text, x + 1, y + 1);
        graphics.setColor(Color.WHITE);
        graphics.drawString(text, x, y);
    }
}
