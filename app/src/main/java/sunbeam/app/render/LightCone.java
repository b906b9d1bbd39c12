package sunbeam.app.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;

/** Cone from the picture's center towards the light, a unit vector in camera space; dim if the light is behind the model. */
public record LightCone(Vector3fc towards) {
    // Shares of the picture's shorter side; width of lines in pixels.
    private static final double LENGTH = 0.4;
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

    private record Outline(double apexX, double apexY, double mouthX, double mouthY, double radius) {}

    private Outline outline(int width, int height) {
        double unit = Math.min(width, height);
        double apexX = 0.5 * width;
        double apexY = 0.5 * height;
        return new Outline(
                apexX,
                apexY,
                apexX + LENGTH * unit * towards.x(),
                apexY - LENGTH * unit * towards.y(),
                HALF_WIDTH * unit * (1 + 0.4 * towards.z()));
    }

    public Rectangle bounds(int width, int height) {
        Outline outline = outline(width, height);
        double reach = outline.radius() + STROKE;
        Rectangle2D covered =
                new Rectangle2D.Double(outline.mouthX() - reach, outline.mouthY() - reach, 2 * reach, 2 * reach);
        covered.add(outline.apexX() - STROKE, outline.apexY() - STROKE);
        covered.add(outline.apexX() + STROKE, outline.apexY() + STROKE);
        return covered.getBounds();
    }

    public void paint(Graphics2D graphics, int width, int height) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Outline outline = outline(width, height);
        double mouthX = outline.mouthX();
        double mouthY = outline.mouthY();
        double radius = outline.radius();
        double length = Math.hypot(mouthX - outline.apexX(), mouthY - outline.apexY());
        int opacity = towards.z() > 0 ? 70 : 30;
        graphics.setStroke(new BasicStroke(STROKE, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        if (length > radius) {
            double acrossX = -(mouthY - outline.apexY()) / length * radius;
            double acrossY = (mouthX - outline.apexX()) / length * radius;
            Path2D sides = new Path2D.Double();
            sides.moveTo(mouthX + acrossX, mouthY + acrossY);
            sides.lineTo(outline.apexX(), outline.apexY());
            sides.lineTo(mouthX - acrossX, mouthY - acrossY);
            graphics.setPaint(new GradientPaint(
                    (float) outline.apexX(),
                    (float) outline.apexY(),
                    color(0),
                    (float) mouthX,
                    (float) mouthY,
                    color(opacity)));
            graphics.fill(sides);
        }
        Ellipse2D mouth = new Ellipse2D.Double(mouthX - radius, mouthY - radius, 2 * radius, 2 * radius);
        graphics.setPaint(color(opacity));
        graphics.fill(mouth);
        graphics.setPaint(color(2 * opacity));
        graphics.draw(mouth);
        graphics.dispose();
    }

    private static Color color(int opacity) {
        return new Color(255, 214, 120, opacity);
    }
}
