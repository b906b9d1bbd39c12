package jrtr.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import org.joml.FrustumIntersection;
import org.joml.Matrix3f;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;

/** Scene graph, by its root, with its view. */
public record SceneGraph(Node root, View view) {
    /** Factor on bounding radii, because the frustum's planes from float matrices err by a few 1e-6. */
    private static final float CULLING_RADIUS_FACTOR = 1.001f;

    /** @param modelToWorld affine, copied */
    record ShapeInstance(Node.Shape shape, Matrix4fc modelToWorld) {
        ShapeInstance {
            modelToWorld = new Matrix4f(modelToWorld);
        }

        BoundingSphere bounds() {
            return shape.vertices().bounds().transformed(modelToWorld);
        }
    }

    List<ShapeInstance> shapes() {
        List<ShapeInstance> shapes = new ArrayList<>();
        collect(root, new Matrix4f(), shapes, new ArrayList<>());
        return shapes;
    }

    List<Node.Light> lights() {
        List<Node.Light> lights = new ArrayList<>();
        collect(root, new Matrix4f(), new ArrayList<>(), lights);
        return lights;
    }

    private static void collect(Node node, Matrix4fc toWorld, List<ShapeInstance> shapes, List<Node.Light> lights) {
        if (node instanceof Node.Group group) {
            Matrix4f childToWorld = toWorld.mul(group.toParent(), new Matrix4f());
            group.children().forEach(child -> collect(child, childToWorld, shapes, lights));
        } else if (node instanceof Node.Shape shape) {
            shapes.add(new ShapeInstance(shape, toWorld));
        } else if (node instanceof Node.Light light) {
            lights.add(light.transformed(toWorld));
        }
    }

    /**
     * Clears the tile to zeros and draws the scene there; no pixel outside is touched. Tiles that cover the target give the same picture as
     * one draw, bit for bit. Pixels without a shape stay zero.
     *
     * @param area part of the picture that the target, which has depth, shows; it has the target's size in pixels
     * @throws IllegalArgumentException if the scene has more than {@link Node.Light#MOST} lights
     */
    public void draw(RenderContext context, View.Area area, FloatTarget target, Tile tile) {
        if (area.part().width() != target.spec().width()
                || area.part().height() != target.spec().height()) {
            throw new IllegalArgumentException("target '" + target.label() + "' of "
                    + target.spec().width() + " x " + target.spec().height() + " cannot show " + area.part());
        }
        List<Node.Light> lights = lights();
        target.clear(tile, 0, 0, 0, 0);
        Matrix4f worldToClip = view.worldToClip(area);
        for (ShapeInstance instance : visible(area.within(tile))) {
            Node.Shape shape = instance.shape();
            ShaderProgram program = shape.program();
            Matrix4fc modelToWorld = instance.modelToWorld();
            program.set("modelToWorld", modelToWorld);
            // The inverse transpose keeps normals orthogonal to the surface under any scaling.
            program.set("normalToWorld", modelToWorld.normal(new Matrix3f()));
            program.set("mirror", modelToWorld.determinant3x3() < 0 ? -1f : 1f);
            program.set("worldToClip", worldToClip);
            if (program.isActive("eyePosition")) {
                program.set("eyePosition", view.camera().centerOfProjection());
            }
            Node.Light.apply(lights, program);
            shape.uniforms().forEach((name, value) -> program.set(name, value.floatValue()));
            context.draw(program, shape.textures(), shape.vertices(), shape.faces(), target, tile);
        }
    }

    /** Returns the shapes that intersect the frustum, nearest first, so that the depth test rejects most of the hidden fragments. */
    private List<ShapeInstance> visible(View.Area area) {
        FrustumIntersection planes = new FrustumIntersection(view.worldToClip(area));
        Matrix4f worldToCamera = view.camera().worldToCamera();
        return shapes().stream()
                .filter(item -> planes.testSphere(
                        item.bounds().center(),
                        CULLING_RADIUS_FACTOR * item.bounds().radius()))
                .sorted(Comparator.comparingDouble(item -> nearestDepth(worldToCamera, item.bounds())))
                .toList();
    }

    private static float nearestDepth(Matrix4f worldToCamera, BoundingSphere bounds) {
        Vector3f center = worldToCamera.transformPosition(bounds.center(), new Vector3f());
        return -center.z() - bounds.radius();
    }
}
