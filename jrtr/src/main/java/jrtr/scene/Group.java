package jrtr.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;

/** A node with children, in the order in which they were added. */
public sealed class Group implements Node permits TransformGroup {
    private final List<Node> children = new ArrayList<>();

    /** An empty group. */
    public Group() {}

    /**
     * Appends a child.
     *
     * @throws IllegalArgumentException if this group would come to stand inside itself
     */
    public final void add(Node child) {
        Objects.requireNonNull(child, "child");
        if (child instanceof Group group && group.contains(this)) {
            throw new IllegalArgumentException("a group cannot stand inside itself");
        }
        children.add(child);
    }

    /** The children; a view that shows later changes. */
    public final List<Node> children() {
        return Collections.unmodifiableList(children);
    }

    private boolean contains(Group searched) {
        if (this == searched) {
            return true;
        }
        return children.stream().anyMatch(child -> child instanceof Group group && group.contains(searched));
    }
}
