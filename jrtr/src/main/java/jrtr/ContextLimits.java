package jrtr;

/**
 * What a driver allows at most.
 *
 * @param textureSize texels along a side of a texture
 * @param arrayLayers layers of a texture array
 * @param renderbufferSize pixels along a side of a depth image
 * @param viewportWidth pixels per row that can be drawn
 * @param viewportHeight rows that can be drawn
 * @param textureUnits textures that one fragment shader can sample
 * @param fragmentUniformComponents floats in a fragment shader's uniforms
 * @param colors images that one draw can write
 */
public record ContextLimits(
        int textureSize,
        int arrayLayers,
        int renderbufferSize,
        int viewportWidth,
        int viewportHeight,
        int textureUnits,
        int fragmentUniformComponents,
        int colors) {}
