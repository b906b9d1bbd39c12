package jrtr;

/**
 * What a driver allows at most.
 *
 * @param textureSize texels along a side of a texture
 * @param arrayLayers layers of a texture array
 * @param targetWidth pixels per row of what is drawn to
 * @param targetHeight rows of what is drawn to
 * @param colors images that one draw can write
 * @param varyings components that a vertex shader hands over
 */
public record ContextLimits(
        int textureSize, int arrayLayers, int targetWidth, int targetHeight, int colors, int varyings) {}
