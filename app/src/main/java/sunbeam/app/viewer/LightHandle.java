package sunbeam.app.viewer;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import javax.swing.Timer;
import org.joml.Vector3f;
import sunbeam.app.render.LightCone;

/** Handle of the light on the picture: a small sun on an arc, where the light's cone opens. It fades while nothing is touched. */
public final class LightHandle {
    /** Distance, in Swing units, at which a finger holds the sun: half of a target of 48. */
    static final int REACH = 24;

    private static final double RADIUS = 8;
    private static final int RAYS = 8;
    // Half of the arc, radians, in steps.
    private static final double ARC = Math.toRadians(50);
    private static final int ARC_STEPS = 24;
    private static final Color SUN = new Color(255, 214, 120);
    private static final Color EDGE = new Color(0, 0, 0, 150);
    private static final int STEP_MILLISECONDS = 50;
    private static final float FADE_PER_STEP = 0.05f;
    private static final long SHOWN_NANOSECONDS = 3_000_000_000L;

    private final Runnable repaint;
    private final Timer timer = new Timer(STEP_MILLISECONDS, event -> fade());
    private LightCone cone = new LightCone(new Vector3f(0, 0, 1));
    /** Opacity while nothing is touched, 0 to 1. */
    float restingOpacity;

    float opacity;
    private long touched;

    LightHandle(Runnable repaint) {
        this.repaint = repaint;
    }

    void follow(LightCone value) {
        cone = value;
    }

    /** Shows the handle for some seconds. */
    void touch() {
        touched = System.nanoTime();
        if (opacity < 1) {
            opacity = 1;
            repaint.run();
        }
        timer.start();
    }

    private void fade() {
        if (System.nanoTime() - touched < SHOWN_NANOSECONDS) {
            return;
        }
        opacity = Math.max(restingOpacity, opacity - FADE_PER_STEP);
        if (opacity == restingOpacity) {
            timer.stop();
        }
        repaint.run();
    }

    boolean isAt(double x, double y, int width, int height) {
        return cone.mouth(width, height).distance(x, y) <= REACH;
    }

    void paint(Graphics2D graphics, int width, int height) {
        if (Math.max(opacity, restingOpacity) == 0) {
            return;
        }
        graphics.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, Math.max(opacity, restingOpacity)));
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Path2D arc = new Path2D.Double();
        for (int i = -ARC_STEPS; i <= ARC_STEPS; i++) {
            Vector3f turned = new Vector3f(cone.towards()).rotateY((float) (ARC * i / ARC_STEPS));
            Point2D at = new LightCone(turned).mouth(width, height);
            if (i == -ARC_STEPS) {
                arc.moveTo(at.getX(), at.getY());
            } else {
                arc.lineTo(at.getX(), at.getY());
            }
        }
        Point2D sun = cone.mouth(width, height);
        Ellipse2D disc = new Ellipse2D.Double(sun.getX() - RADIUS, sun.getY() - RADIUS, 2 * RADIUS, 2 * RADIUS);
        boolean isBehind = cone.towards().z() < 0;
        for (boolean isEdge : new boolean[] {true, false}) {
            graphics.setColor(isEdge ? EDGE : isBehind ? SUN.darker() : SUN);
            graphics.setStroke(new BasicStroke(isEdge ? 4 : 2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            graphics.draw(arc);
            for (int i = 0; i < RAYS; i++) {
                double x = Math.cos(2 * Math.PI * i / RAYS);
                double y = Math.sin(2 * Math.PI * i / RAYS);
                graphics.draw(new Line2D.Double(
                        sun.getX() + 1.5 * RADIUS * x,
                        sun.getY() + 1.5 * RADIUS * y,
                        sun.getX() + 2.1 * RADIUS * x,
                        sun.getY() + 2.1 * RADIUS * y));
            }
            graphics.draw(disc);
        }
        graphics.fill(disc);
        graphics.dispose();
    }
}
