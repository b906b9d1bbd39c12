package jrtr;

/** Texels that a shader can sample. Bound to a sampler by name, with a {@link Binding}. */
public interface Texture {

    /** The name given at creation, for messages. */
    String label();

    /** Whether the shader's sampler is a {@code sampler2DArray} (also with one layer) rather than a {@code sampler2D}. */
    boolean isArray();
}
