package jrtr.scene;

import java.util.Objects;

/**
 * A leaf that shines; the groups above turn its direction.
 *
 * @param light what
 */
public record LightNode(Light light) implements Node {

    /** Rejects null. */
    public LightNode {
        Objects.requireNonNull(light, "light");
    }
}
