package jrtr.scene;

import java.util.ArrayList;
import java.util.List;
import jrtr.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/**
 * A scene.
 *
 * @param root all that is in it
 * @param camera where it is seen from
 * @param frustum how much of it is seen
 */
public record SceneGraph(Node root, Camera camera, Frustum frustum) {
    /**
     * A shape at its place.
     *
     * @param modelToWorld where; affine, copied
     */
    public record Placed(Shape shape, Matrix4fc modelToWorld) {
        public Placed {
            modelToWorld = new Matrix4f(modelToWorld);
        }

        /** A sphere in world space that holds the shape. */
        public BoundingSphere bounds() {
            return shape.vertices().bounds().transformed(modelToWorld);
        }
    }

    /** The shapes, each at its place in the world: depth first, children in their order. */
    public List<Placed> shapes() {
        List<Placed> shapes = new ArrayList<>();
        collect(root, new Matrix4f(), shapes, new ArrayList<>());
        return shapes;
    }

    /** The lights in the same order, with directions in the world. */
    public List<Light> lights() {
        List<Light> lights = new ArrayList<>();
        collect(root, new Matrix4f(), new ArrayList<>(), lights);
        return lights;
    }

    private static void collect(Node node, Matrix4fc toWorld, List<Placed> shapes, List<Light> lights) {
        if (node instanceof Group group) {
            Matrix4f childToWorld = toWorld.mul(group.toParent(), new Matrix4f());
            group.children().forEach(child -> collect(child, childToWorld, shapes, lights));
        } else if (node instanceof Shape shape) {
            shapes.add(new Placed(shape, toWorld));
        } else if (node instanceof Light light) {
            lights.add(light.transformed(toWorld));
        }
    }
}
