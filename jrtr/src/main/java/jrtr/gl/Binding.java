package jrtr.gl;

/**
 * Texture bound to a sampler for one draw.
 *
 * @param sampler name of the program's sampler uniform
 * @param texture the texture that it samples
 */
public record Binding(String sampler, Texture texture) {}
