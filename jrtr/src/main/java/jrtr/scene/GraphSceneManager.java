package jrtr.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import jrtr.VertexData.BoundingSphere;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/** Contents of a scene graph in world space, by one walk in depth first, children in order. */
public final class GraphSceneManager {
    private final IdentityHashMap<TransformGroup, Matrix4fc> groups = new IdentityHashMap<>();
    private final List<RenderItem> items = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<Camera> cameras = new ArrayList<>();

    /** Throws {@link IllegalArgumentException} if the graph has several cameras. */
    public GraphSceneManager(Node root) {
        walk(root, new Matrix4f());
        if (cameras.size() > 1) {
            throw new IllegalArgumentException(
                    "the scene graph has " + cameras.size() + " cameras; a picture needs one");
        }
    }

    private void walk(Node node, Matrix4fc toWorld) {
        if (node instanceof TransformGroup group) {
            Matrix4fc inner = toWorld.mul(group.transform(), new Matrix4f());
            groups.put(group, inner);
            group.children().forEach(child -> walk(child, inner));
        } else if (node instanceof Shape shape) {
            items.add(new RenderItem(shape, toWorld));
        } else if (node instanceof Light light) {
            lights.add(light.transformed(toWorld));
        } else if (node instanceof Camera camera) {
            cameras.add(camera.transformed(toWorld));
        }
    }

    /** Returns the matrix from the space of a group's children to world space; the last one for a group at several places. */
    public Matrix4fc toWorld(TransformGroup group) {
        Matrix4fc found = groups.get(group);
        if (found == null) {
            throw new IllegalArgumentException("the group is not in this scene graph");
        }
        return found;
    }

    /** Returns the shapes in the order in which they are drawn. */
    public List<RenderItem> items() {
        return List.copyOf(items);
    }

    public List<Light> lights() {
        return List.copyOf(lights);
    }

    public Optional<Camera> camera() {
        return cameras.stream().findFirst();
    }

    /** Returns a sphere that contains all shapes; empty without shapes. */
    public Optional<BoundingSphere> bounds() {
        return items.stream().map(RenderItem::bounds).reduce(BoundingSphere::with);
    }
}
