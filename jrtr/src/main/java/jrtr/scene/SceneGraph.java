package jrtr.scene;

import java.util.ArrayList;
import java.util.List;
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
    /** The shapes, each at its place in the world: depth first, children in their order. */
    public List<RenderItem> shapes() {
        List<RenderItem> shapes = new ArrayList<>();
        collect(root, new Matrix4f(), shapes, new ArrayList<>());
        return shapes;
    }

    /** The lights in the same order, with directions in the world. */
    public List<Light> lights() {
        List<Light> lights = new ArrayList<>();
        collect(root, new Matrix4f(), new ArrayList<>(), lights);
        return lights;
    }

    private static void collect(Node node, Matrix4fc toWorld, List<RenderItem> shapes, List<Light> lights) {
        if (node instanceof Group group) {
            Matrix4f childToWorld = toWorld.mul(group.toParent(), new Matrix4f());
            group.children().forEach(child -> collect(child, childToWorld, shapes, lights));
        } else if (node instanceof Shape shape) {
            shapes.add(new RenderItem(shape, toWorld));
        } else if (node instanceof Light light) {
            lights.add(light.transformed(toWorld));
        }
    }
}
