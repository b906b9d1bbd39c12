package jrtr.scene;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/**
 * The leaves of a graph, depth first, children in the order in which they were added. The graph must not change
 * meanwhile.
 */
final class LeafIterator implements Iterator<PlacedNode> {
    private final Deque<PlacedNode> open = new ArrayDeque<>();

    LeafIterator(Node root) {
        push(root, new Matrix4f());
        expand();
    }

    @Override
    public boolean hasNext() {
        return !open.isEmpty();
    }

    @Override
    public PlacedNode next() {
        if (open.isEmpty()) {
            throw new NoSuchElementException("no more leaves");
        }
        PlacedNode leaf = open.pop();
        expand();
        return leaf;
    }

    /** Replaces groups on top by their children until a leaf is on top. */
    private void expand() {
        while (!open.isEmpty() && open.peek().node() instanceof Group group) {
            Matrix4fc toWorld = open.pop().toWorld();
            List<Node> children = group.children();
            for (int i = children.size() - 1; i >= 0; i--) {
                push(children.get(i), toWorld);
            }
        }
    }

    private void push(Node node, Matrix4fc parentToWorld) {
        Matrix4fc toWorld = node instanceof TransformGroup group
                ? parentToWorld.mul(group.transformation(), new Matrix4f())
                : parentToWorld;
        open.push(new PlacedNode(node, toWorld));
    }
}
