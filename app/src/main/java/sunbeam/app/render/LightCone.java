package sunbeam.app.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;

/**
 * Marker of the light's direction: a cone at the model's center that opens towards the light, dim if the light is behind the model.
 *
 * @param towards the light, camera space
 */
public record LightCone(Vector3fc towards) {
    private static final double REACH = 0.4;
    private static final double HALF_WIDTH = 0.035;
    private static final float STROKE = 1.4f;

    public LightCone {
        towards = new Vector3f(towards);
    }

    public static LightCone of(Scene scene) {
        return new LightCone(scene.view()
                .camera()
                .worldToCamera()
                .transformDirection(scene.light().towards(), new Vector3f()));
    }

    private record Place(double fromX, double fromY, double lampX, double lampY, double radius) {}

    private Place place(int width, int height) {
        double unit = Math.min(width, height);
        double fromX = 0.5 * width;
        double fromY = 0.5 * height;
        return new Place(
                fromX,
                fromY,
                fromX + REACH * unit * towards.x(),
                fromY - REACH * unit * towards.y(),
                HALF_WIDTH * unit * (1 + 0.4 * towards.z()));
    }

    public Rectangle bounds(int width, int height) {
        Place place = place(width, height);
        double reach = place.radius() + STROKE;
        Rectangle2D covered =
                new Rectangle2D.Double(place.lampX() - reach, place.lampY() - reach, 2 * reach, 2 * reach);
        covered.add(place.fromX() - STROKE, place.fromY() - STROKE);
        covered.add(place.fromX() + STROKE, place.fromY() + STROKE);
        return covered.getBounds();
    }

    /** Draws the cone and disposes of the graphics. */
    public void paint(Graphics2D graphics, int width, int height) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Place place = place(width, height);
        double lampX = place.lampX();
        double lampY = place.lampY();
        double radius = place.radius();
        double length = Math.hypot(lampX - place.fromX(), lampY - place.fromY());
        graphics.setColor(new Color(255, 214, 120, towards.z() > 0 ? 200 : 80));
        graphics.setStroke(new BasicStroke(STROKE, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        if (length > radius) {
            double acrossX = -(lampY - place.fromY()) / length * radius;
            double acrossY = (lampX - place.fromX()) / length * radius;
            Path2D sides = new Path2D.Double();
            sides.moveTo(lampX + acrossX, lampY + acrossY);
            sides.lineTo(place.fromX(), place.fromY());
            sides.lineTo(lampX - acrossX, lampY - acrossY);
            graphics.draw(sides);
        }
        Ellipse2D lamp = new Ellipse2D.Double(lampX - radius, lampY - radius, 2 * radius, 2 * radius);
        graphics.draw(lamp);
        graphics.setColor(new Color(255, 214, 120, towards.z() > 0 ? 90 : 30));
        graphics.fill(lamp);
        graphics.dispose();
    }
}
