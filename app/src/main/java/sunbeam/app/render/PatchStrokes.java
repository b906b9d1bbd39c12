package sunbeam.app.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;

/** Strokes along the nanostructure's x axis from an even grid of dots on the skin, foreshortened. */
public final class PatchStrokes {
    // In pixels: distance of dots, length of a stroke in the picture plane, diameter of a dot.
    private static final int STEP = 24;
    private static final double LENGTH = 18;
    private static final double DOT = 4;
    private static final Color LINE = new Color(255, 255, 255, 220);
    private static final Color EDGE = new Color(0, 0, 0, 150);

    private PatchStrokes() {}

    /** Draws the strokes and disposes of the graphics. */
    public static void paint(Graphics2D graphics, SceneSession session, int width, int height) {
        float[] alongX = session.patchDirections(width, height);
        Scene scene = session.scene();
        double perPixel = scene.view().halfHeight(width, height) / (0.5 * height);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Vector3f along = new Vector3f();
        for (int y = STEP / 2; y < height; y += STEP) {
            for (int x = STEP / 2; x < width; x += STEP) {
                int texel = 3 * (y * width + x);
                along.set(alongX[texel], alongX[texel + 1], alongX[texel + 2]);
                if (along.lengthSquared() == 0) {
                    continue;
                }
                scene.view().camera().worldToCamera().transformDirection(along);
                double fromX = x + 0.5;
                double fromY = y + 0.5;
                // At the pixel's point (X, Y, -1) of the picture's plane, a step of (a, b, c) moves it by (a + c X, b +
                // c Y).
                double right = along.x + along.z * perPixel * (fromX - 0.5 * width);
                double up = along.y - along.z * perPixel * (fromY - 0.5 * height);
                stroke(graphics, fromX, fromY, fromX + LENGTH * right, fromY - LENGTH * up);
            }
        }
        graphics.dispose();
    }

    private static void stroke(Graphics2D graphics, double fromX, double fromY, double toX, double toY) {
        Line2D line = new Line2D.Double(fromX, fromY, toX, toY);
        graphics.setColor(EDGE);
        graphics.setStroke(new BasicStroke(3));
        graphics.draw(line);
        graphics.setColor(LINE);
        graphics.setStroke(new BasicStroke(1.2f));
        graphics.draw(line);
        graphics.fill(new Ellipse2D.Double(fromX - DOT / 2, fromY - DOT / 2, DOT, DOT));
    }
}
