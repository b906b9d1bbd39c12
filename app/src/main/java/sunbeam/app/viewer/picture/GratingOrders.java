package sunbeam.app.viewer.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Optional;
import sunbeam.app.viewer.picture.MapView.Labels;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.text.Text;

/**
 * Directions of a grating's orders by the grating equation: (u, v) is order times wavelength times the grating's spatial frequency.
 *
 * @param wave spatial frequency of the heights, in cycles per meter of the tangent frame
 * @param light direction to the light, tangent frame
 */
public record GratingOrders(SpatialFrequency wave, Direction light) {
    /** Marked wavelengths in meters: blue, green, red. */
    public static final List<Double> WAVELENGTHS = List.of(450e-9, 550e-9, 650e-9);

    private static final double GREEN = WAVELENGTHS.get(1);
    // Smallest distance of neighboring marks in pixels; orders are skipped, since closer marks would hide the map.
    private static final double CLOSEST = 12;
    private static final List<Color> COLORS = List.of(new Color(0x5080ff), new Color(0x30d030), new Color(0xff4030));

    /**
     * Returns the direction of an order as (x, y) of a unit vector; empty if it is below the horizon.
     *
     * @param wavelength in meters
     */
    public Optional<Point2D> direction(int order, double wavelength) {
        double x = -light.x() - order * wavelength * wave.x();
        double y = -light.y() - order * wavelength * wave.y();
        return x * x + y * y < 1 ? Optional.of(new Point2D.Double(x, y)) : Optional.empty();
    }

    /**
     * Paints the marks on the BRDF map, a disc of diameter {@code side} whose left edge is at {@code left}, in pixels.
     *
     * @param withMirror whether order 0 is marked, which all gratings share
     */
    void paint(Graphics2D graphics, Labels labels, boolean withMirror, double left, double side) {
        double apart = 0.5 * side * GREEN * wave.length();
        int step = (int) Math.max(1, Math.ceil(CLOSEST / apart));
        int last = (int) Math.floor(2 / (WAVELENGTHS.get(0) * wave.length()));
        // Low orders come first, since a label that would cover another is left out.
        for (int order = 0; order <= last; order += step) {
            if (order > 0 || withMirror) {
                paint(graphics, labels, order, left, side);
            }
            if (order > 0) {
                paint(graphics, labels, -order, left, side);
            }
        }
    }

    private void paint(Graphics2D graphics, Labels labels, int order, double left, double side) {
        Optional<Point2D> previous = Optional.empty();
        for (int i = 0; i < WAVELENGTHS.size(); i++) {
            Optional<Point2D> at = direction(order, WAVELENGTHS.get(i))
                    .map(found -> new Point2D.Double(
                            left + 0.5 * side * (1 + found.getX()), 0.5 * side * (1 - found.getY())));
            if (at.isEmpty()) {
                return;
            }
            if (previous.isPresent()) {
                graphics.setColor(Color.GRAY);
                graphics.setStroke(new BasicStroke(1f));
                graphics.draw(new Line2D.Double(previous.get(), at.get()));
                paintDot(graphics, order == 0 ? Color.WHITE : COLORS.get(i - 1), previous.get());
            }
            paintDot(graphics, order == 0 ? Color.WHITE : COLORS.get(i), at.get());
            if (WAVELENGTHS.get(i) == GREEN) {
                String name = order == 0 ? "0" : Text.format("%+d", order);
                labels.paint(name, at.get().getX(), at.get().getY());
            }
            previous = at;
        }
    }

    private static void paintDot(Graphics2D graphics, Color color, Point2D at) {
        Ellipse2D dot = new Ellipse2D.Double(at.getX() - 2.5, at.getY() - 2.5, 5, 5);
        graphics.setColor(color);
        graphics.fill(dot);
        graphics.setStroke(new BasicStroke(1f));
        graphics.setColor(Color.BLACK);
        graphics.draw(dot);
    }
}
