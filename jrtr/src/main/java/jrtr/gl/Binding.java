package jrtr.gl;

/**
 * A texture for one draw.
 *
 * @param sampler name of the program's sampler uniform
 * @param texture what it samples
 */
public record Binding(String sampler, Texture texture) {}
