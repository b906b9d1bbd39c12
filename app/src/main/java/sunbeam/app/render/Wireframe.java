package sunbeam.app.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.Mesh;

/** Draws the edges of a mesh's triangles, and its normals as strokes; nearer triangles hide farther ones. */
public final class Wireframe {
    private static final Color EDGE = new Color(0xd0d6e0);
    private static final Color NORMAL = new Color(0xffb040);
    private static final float STROKE = 0.5f;

    /** Relative to the radius of the mesh's bounds. */
    private static final float NORMAL_LENGTH = 0.03f;

    private Wireframe() {}

    public static BufferedImage draw(Scene scene, Mesh mesh, boolean normals, int width, int height) {
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
        Color behind = new Color(scene.get(SceneSettings.BACKGROUND).rgb());
        graphics.setColor(behind);
        graphics.fillRect(0, 0, width, height);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        graphics.setStroke(new BasicStroke(STROKE));
        for (int triangle : triangles) {
            Path2D outline = new Path2D.Double();
            for (int corner = 0; corner < 3; corner++) {
                int vertex = indices[3 * triangle + corner];
                Point2D place = project(vertices, vertex, scale, width, height);
                if (corner == 0) {
                    outline.moveTo(place.getX(), place.getY());
                } else {
                    outline.lineTo(place.getX(), place.getY());
                }
            }
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
        Matrix4f view = new Matrix4f(scene.view().camera().worldToCamera())
                .mul(Framing.toWorld(scene.orientation(), mesh.toVertexData().bounds()));
        float[] vertices = new float[mesh.positions().length];
        float length = offset * mesh.toVertexData().bounds().radius();
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
