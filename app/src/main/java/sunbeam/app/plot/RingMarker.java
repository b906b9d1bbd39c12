package sunbeam.app.plot;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RectangularShape;
import org.knowm.xchart.style.markers.Marker;

/** A ring or a frame, twice as wide as the other marks, through which these are seen. */
final class RingMarker extends Marker {
    private static final BasicStroke STROKE = new BasicStroke(2.5f);

    private final boolean round;

    RingMarker(boolean round) {
        this.round = round;
    }

    @Override
    public void paint(Graphics2D graphics, double x, double y, int size) {
        graphics.setStroke(STROKE);
        RectangularShape shape = round ? new Ellipse2D.Double() : new Rectangle2D.Double();
        shape.setFrame(x - size, y - size, 2.0 * size, 2.0 * size);
        graphics.draw(shape);
    }
}
