package jrtr.gl;

/** Texture bound to a program's sampler uniform for one draw. */
public record Binding(String sampler, Texture texture) {}
