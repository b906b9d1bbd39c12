package jrtr.scene;

import java.util.ArrayList;
import java.util.List;
import jrtr.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/** Scene graph, by its root, with the position and extent of its view. */
public record SceneGraph(Node root, Camera camera, Frustum frustum) {
    /**
     * Shape with its transformation to world space.
     *
     * @param modelToWorld affine, copied
     */
    public record ShapeInstance(Shape shape, Matrix4fc modelToWorld) {
        public ShapeInstance {
            modelToWorld = new Matrix4f(modelToWorld);
        }

        /** Returns a sphere in world space that encloses the shape. */
        public BoundingSphere bounds() {
            return shape.vertices().bounds().transformed(modelToWorld);
        }
    }

    /** Returns the shapes with their transformations to world space: depth first, children in their order. */
    public List<ShapeInstance> shapes() {
        List<ShapeInstance> shapes = new ArrayList<>();
        collect(root, new Matrix4f(), shapes, new ArrayList<>());
        return shapes;
    }

    /** Returns the lights, with directions in world space: depth first, children in their order. */
    public List<Light> lights() {
        List<Light> lights = new ArrayList<>();
        collect(root, new Matrix4f(), new ArrayList<>(), lights);
        return lights;
    }

    private static void collect(Node node, Matrix4fc toWorld, List<ShapeInstance> shapes, List<Light> lights) {
        if (node instanceof Group group) {
            Matrix4f childToWorld = toWorld.mul(group.toParent(), new Matrix4f());
            group.children().forEach(child -> collect(child, childToWorld, shapes, lights));
        } else if (node instanceof Shape shape) {
            shapes.add(new ShapeInstance(shape, toWorld));
        } else if (node instanceof Light light) {
            lights.add(light.transformed(toWorld));
        }
    }
}
