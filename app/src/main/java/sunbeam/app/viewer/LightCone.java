package sunbeam.app.viewer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Shows where the light comes from: a cone around the model's middle that opens towards it; dim where the light is behind
 * the model.
 *
 * @param towards the light, camera space
 */
record LightCone(Vector3fc towards) {
    private static final double REACH = 0.4;
    private static final double HALF_WIDTH = 0.035;

    LightCone {
        towards = new Vector3f(towards);
    }

    void paint(Graphics2D graphics, int width, int height) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        double unit = Math.min(width, height);
        double fromX = 0.5 * width;
        double fromY = 0.5 * height;
        double lampX = fromX + REACH * unit * towards.x();
        double lampY = fromY - REACH * unit * towards.y();
        double radius = HALF_WIDTH * unit * (1 + 0.4 * towards.z());
        double length = Math.hypot(lampX - fromX, lampY - fromY);
        Color color = new Color(255, 214, 120, towards.z() > 0 ? 200 : 80);
        graphics.setColor(color);
        graphics.setStroke(new BasicStroke(1.4f));
        if (length > radius) {
            double acrossX = -(lampY - fromY) / length * radius;
            double acrossY = (lampX - fromX) / length * radius;
            Path2D sides = new Path2D.Double();
            sides.moveTo(lampX + acrossX, lampY + acrossY);
            sides.lineTo(fromX, fromY);
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
