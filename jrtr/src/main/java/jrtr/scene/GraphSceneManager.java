package jrtr.scene;

import java.util.Iterator;
import java.util.Objects;
import java.util.Spliterators;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/** A scene from a graph. */
public final class GraphSceneManager implements SceneManagerInterface {
    private final Node root;
    private final Camera camera;
    private final Frustum frustum;

    /** A scene whose graph may change between draws. */
    public GraphSceneManager(Node root, Camera camera, Frustum frustum) {
        this.root = Objects.requireNonNull(root, "root");
        this.camera = Objects.requireNonNull(camera, "camera");
        this.frustum = Objects.requireNonNull(frustum, "frustum");
    }

    @Override
    public Iterator<RenderItem> shapes() {
        return leaves().<RenderItem>mapMulti((leaf, out) -> {
                    if (leaf.node() instanceof ShapeNode node) {
                        out.accept(new RenderItem(node.shape(), leaf.toWorld()));
                    }
                })
                .iterator();
    }

    @Override
    public Iterator<Light> lights() {
        return leaves().<Light>mapMulti((leaf, out) -> {
                    if (leaf.node() instanceof LightNode node) {
                        out.accept(node.light().transformed(leaf.toWorld()));
                    }
                })
                .iterator();
    }

    private Stream<PlacedNode> leaves() {
        return StreamSupport.stream(Spliterators.spliteratorUnknownSize(new LeafIterator(root), 0), false);
    }

    @Override
    public Camera camera() {
        return camera;
    }

    @Override
    public Frustum frustum() {
        return frustum;
    }
}
