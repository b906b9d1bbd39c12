package sunbeam.app.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.stream.IntStream;
import jrtr.VertexData.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.mesh.Mesh;

/** Line drawings over a scene's picture or in its place. */
public final class LineDrawings {
    // In pixels: distance of dots, length of a stroke in the picture plane, diameter of a dot.
    private static final int DOT_STEP = 24;
    private static final double STROKE_LENGTH = 18;
    private static final double DOT = 4;
    private static final Color STROKE = new Color(255, 255, 255, 220);
    private static final Color STROKE_EDGE = new Color(0, 0, 0, 150);

    private static final Color EDGE = new Color(0xd0d6e0);
    private static final Color NORMAL = new Color(0xffb040);

    /** Relative to the radius of the mesh's bounds. */
    private static final float NORMAL_LENGTH = 0.03f;

    private LineDrawings() {}

    static void smooth(Graphics2D graphics) {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    /** Draws strokes along the nanostructure's x axis from an even grid of dots on the skin, foreshortened; disposes of the graphics. */
    public static void strokes(Graphics2D graphics, SceneSession session, int width, int height) {
        float[] alongX = session.patchDirections(width, height);
        double perPixel = session.scene().view().halfHeight(width, height) / (0.5 * height);
        smooth(graphics);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Vector3f along = new Vector3f();
        for (int y = DOT_STEP / 2; y < height; y += DOT_STEP) {
            for (int x = DOT_STEP / 2; x < width; x += DOT_STEP) {
                int texel = 3 * (y * width + x);
                along.set(alongX[texel], alongX[texel + 1], alongX[texel + 2]);
                if (along.lengthSquared() == 0) {
                    continue;
                }
                session.scene().view().camera().worldToCamera().transformDirection(along);
                double fromX = x + 0.5;
                double fromY = y + 0.5;
                // At the point (X, Y, -1) of the picture's plane, a step of (a, b, c) moves it by (a + c X, b + c Y).
                double right = along.x + along.z * perPixel * (fromX - 0.5 * width);
                double up = along.y - along.z * perPixel * (fromY - 0.5 * height);
                stroke(graphics, fromX, fromY, fromX + STROKE_LENGTH * right, fromY - STROKE_LENGTH * up);
            }
        }
        graphics.dispose();
    }

    private static void stroke(Graphics2D graphics, double fromX, double fromY, double toX, double toY) {
        Line2D line = new Line2D.Double(fromX, fromY, toX, toY);
        graphics.setColor(STROKE_EDGE);
        graphics.setStroke(new BasicStroke(3));
        graphics.draw(line);
        graphics.setColor(STROKE);
        graphics.setStroke(new BasicStroke(1.2f));
        graphics.draw(line);
        graphics.fill(new Ellipse2D.Double(fromX - DOT / 2, fromY - DOT / 2, DOT, DOT));
    }

    /** Draws the edges of a mesh's triangles, and its normals as strokes; nearer triangles hide farther ones. */
    public static BufferedImage wireframe(Scene scene, Mesh mesh, boolean normals, int width, int height) {
        float[] vertices = vertices(scene, mesh, 0);
        float[] tips = vertices(scene, mesh, NORMAL_LENGTH);
        double scale = 0.5 * height / scene.view().halfHeight(width, height);
        int[] indices = mesh.indices();
        // Farthest first, without triangles that reach behind the eye.
        int[] triangles = IntStream.range(0, mesh.triangles())
                .filter(t -> IntStream.range(0, 3).allMatch(corner -> depth(vertices, indices[3 * t + corner]) > 0))
                .boxed()
                .sorted(Comparator.comparingDouble(t -> -IntStream.range(0, 3)
                        .mapToDouble(corner -> depth(vertices, indices[3 * t + corner]))
                        .sum()))
                .mapToInt(Integer::intValue)
                .toArray();
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        Color behind = new Color(scene.background().rgb());
        graphics.setColor(behind);
        graphics.fillRect(0, 0, width, height);
        smooth(graphics);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        graphics.setStroke(new BasicStroke(0.5f));
        for (int triangle : triangles) {
            Point2D first = project(vertices, indices[3 * triangle], scale, width, height);
            Point2D second = project(vertices, indices[3 * triangle + 1], scale, width, height);
            Point2D third = project(vertices, indices[3 * triangle + 2], scale, width, height);
            Path2D outline = new Path2D.Double(new Line2D.Double(first, second));
            outline.lineTo(third.getX(), third.getY());
            outline.closePath();
            graphics.setColor(behind);
            graphics.fill(outline);
            graphics.setColor(EDGE);
            graphics.draw(outline);
            graphics.setColor(NORMAL);
            for (int corner = 0; normals && corner < 3; corner++) {
                int vertex = indices[3 * triangle + corner];
                graphics.draw(new Line2D.Double(
                        project(vertices, vertex, scale, width, height), project(tips, vertex, scale, width, height)));
            }
        }
        graphics.dispose();
        return image;
    }

    private static float depth(float[] vertices, int vertex) {
        return -vertices[3 * vertex + 2];
    }

    private static Point2D project(float[] vertices, int vertex, double scale, int width, int height) {
        double depth = depth(vertices, vertex);
        return new Point2D.Double(
                0.5 * width + scale * vertices[3 * vertex] / depth,
                0.5 * height - scale * vertices[3 * vertex + 1] / depth);
    }

    /** Vertices in camera space: x right, y up, z towards the viewer; moved along the normals by radii of the mesh's bounds. */
    private static float[] vertices(Scene scene, Mesh mesh, float offset) {
        BoundingSphere bounds = mesh.toVertexData().bounds();
        Matrix4f view = scene.view().camera().worldToCamera();
        view.mul(SceneGraph.modelToWorld(scene.orientation(), bounds.center()));
        float[] vertices = new float[mesh.positions().length];
        float length = offset * bounds.radius();
        Vector3f place = new Vector3f();
        for (int i = 0; i < vertices.length; i += 3) {
            place.set(mesh.normals()[i], mesh.normals()[i + 1], mesh.normals()[i + 2])
                    .mul(length);
            view.transformPosition(place.add(mesh.positions()[i], mesh.positions()[i + 1], mesh.positions()[i + 2]));
            vertices[i] = place.x;
            vertices[i + 1] = place.y;
            vertices[i + 2] = place.z;
        }
        return vertices;
    }
}
