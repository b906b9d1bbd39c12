package jrtr;

/**
 * Largest sizes and counts that a driver allows.
 *
 * @param textureSize texels along a side of a texture
 * @param targetWidth pixels per row of a render target
 * @param targetHeight rows of a render target
 * @param colors color images of a render target that one draw can write
 * @param varyings scalar components that a vertex shader can pass to a fragment shader
 */
public record ContextLimits(
        int textureSize, int arrayLayers, int targetWidth, int targetHeight, int colors, int varyings) {}
