package jrtr.gl;

import java.util.Objects;

/**
 * A texture for one draw.
 *
 * @param sampler name of the program's sampler uniform
 * @param texture what it samples
 */
public record Binding(String sampler, Texture texture) {

    /** Rejects null. */
    public Binding {
        Objects.requireNonNull(sampler, "sampler");
        Objects.requireNonNull(texture, "texture");
    }
}
