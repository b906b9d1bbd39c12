package sunbeam.app.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;

/** Cone from the picture's center towards the light, a unit vector in camera space; dim if the light is behind the model. */
public record LightCone(Vector3fc towards) {
    // Shares of the picture's shorter side; width of lines in pixels.
    public static final double LENGTH = 0.4;
    private static final double HALF_WIDTH = 0.035;
    private static final float LINE_WIDTH = 1.4f;

    public static LightCone of(Scene scene) {
        var toCamera = scene.view().camera().worldToCamera();
        return new LightCone(toCamera.transformDirection(scene.light().towards(), new Vector3f()));
    }

    /** Returns the middle of the cone's mouth; its apex is the picture's middle. */
    public Point2D mouth(int width, int height) {
        double length = LENGTH * Math.min(width, height);
        return new Point2D.Double(0.5 * width + length * towards.x(), 0.5 * height - length * towards.y());
    }

    private double radius(int width, int height) {
        return HALF_WIDTH * Math.min(width, height) * (1 + 0.4 * towards.z());
    }

    public Rectangle bounds(int width, int height) {
        Point2D mouth = mouth(width, height);
        double reach = radius(width, height) + LINE_WIDTH;
        Rectangle2D covered = new Rectangle2D.Double(mouth.getX() - reach, mouth.getY() - reach, 2 * reach, 2 * reach);
        covered.add(0.5 * width - LINE_WIDTH, 0.5 * height - LINE_WIDTH);
        covered.add(0.5 * width + LINE_WIDTH, 0.5 * height + LINE_WIDTH);
        return covered.getBounds();
    }

    public void paint(Graphics2D graphics, int width, int height) {
        LineDrawings.smooth(graphics);
        Point2D apex = new Point2D.Double(0.5 * width, 0.5 * height);
        Point2D mouth = mouth(width, height);
        double radius = radius(width, height);
        double length = mouth.distance(apex);
        int opacity = towards.z() > 0 ? 70 : 30;
        graphics.setStroke(new BasicStroke(LINE_WIDTH, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        if (length > radius) {
            double acrossX = -(mouth.getY() - apex.getY()) / length * radius;
            double acrossY = (mouth.getX() - apex.getX()) / length * radius;
            Path2D sides = new Path2D.Double();
            sides.moveTo(mouth.getX() + acrossX, mouth.getY() + acrossY);
            sides.lineTo(apex.getX(), apex.getY());
            sides.lineTo(mouth.getX() - acrossX, mouth.getY() - acrossY);
            graphics.setPaint(new GradientPaint(apex, color(0), mouth, color(opacity)));
            graphics.fill(sides);
        }
        Ellipse2D end = new Ellipse2D.Double(mouth.getX() - radius, mouth.getY() - radius, 2 * radius, 2 * radius);
        graphics.setPaint(color(opacity));
        graphics.fill(end);
        graphics.setPaint(color(2 * opacity));
        graphics.draw(end);
        graphics.dispose();
    }

    private static Color color(int opacity) {
        return new Color(255, 214, 120, opacity);
    }
}
