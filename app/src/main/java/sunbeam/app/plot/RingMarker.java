package sunbeam.app.plot;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import org.knowm.xchart.style.markers.Marker;

/** A ring, twice as wide as the other marks, through which these are seen. */
final class RingMarker extends Marker {
    private static final BasicStroke STROKE = new BasicStroke(2.5f);

    @Override
    public void paint(Graphics2D graphics, double x, double y, int size) {
        graphics.setStroke(STROKE);
        graphics.draw(new Ellipse2D.Double(x - size, y - size, 2.0 * size, 2.0 * size));
    }
}
