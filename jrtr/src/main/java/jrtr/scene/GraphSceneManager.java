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
public final class GraphSceneManager implements SceneManagerInterface {
    private final IdentityHashMap<TransformGroup, Matrix4fc> groups = new IdentityHashMap<>();
    private final List<RenderItem> items = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<Camera> cameras = new ArrayList<>();
    private final Optional<BoundingSphere> bounds;

    /** Throws {@link IllegalArgumentException} if the graph has several cameras. */
    public GraphSceneManager(Node root) {
        bounds = walk(root, new Matrix4f());
        if (cameras.size() > 1) {
            throw new IllegalArgumentException(
                    "the scene graph has " + cameras.size() + " cameras; a picture needs one");
        }
    }

    /** Collects the leaves below a node, and returns the sphere around its shapes in the space of the node's parent. */
    private Optional<BoundingSphere> walk(Node node, Matrix4fc toWorld) {
        if (node instanceof TransformGroup group) {
            return walk(group, toWorld.mul(group.transform(), new Matrix4f()));
        } else if (node instanceof Shape shape) {
            items.add(new RenderItem(shape, toWorld));
            return Optional.of(shape.mesh().bounds());
        } else if (node instanceof Light light) {
            lights.add(light.transformed(toWorld));
        } else if (node instanceof Camera camera) {
            cameras.add(camera.transformed(toWorld));
        }
        return Optional.empty();
    }

    private Optional<BoundingSphere> walk(TransformGroup group, Matrix4fc toWorld) {
        groups.put(group, toWorld);
        Optional<BoundingSphere> sphere = Optional.empty();
        for (Node child : group.children()) {
            Optional<BoundingSphere> next = walk(child, toWorld);
            Optional<BoundingSphere> before = sphere;
            sphere = next.isPresent() && before.isPresent() ? next.map(before.get()::with) : before.or(() -> next);
        }
        return sphere.map(inner -> inner.transformed(group.transform()));
    }

    /** Returns the matrix from the space of a group's children to world space; the last one for a group at several places. */
    public Matrix4fc toWorld(TransformGroup group) {
        Matrix4fc found = groups.get(group);
        if (found == null) {
            throw new IllegalArgumentException("the group is not in this scene graph");
        }
        return found;
    }

    @Override
    public List<RenderItem> items() {
        return List.copyOf(items);
    }

    @Override
    public List<Light> lights() {
        return List.copyOf(lights);
    }

    @Override
    public Optional<Camera> camera() {
        return cameras.stream().findFirst();
    }

    @Override
    public Optional<BoundingSphere> bounds() {
        return bounds;
    }
}
