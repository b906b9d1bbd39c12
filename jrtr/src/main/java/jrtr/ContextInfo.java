package jrtr;

/**
 * Names and versions of the driver and the device that render.
 *
 * @param renderer the device, such as {@code llvmpipe (LLVM 15.0.6, 256 bits)}
 */
public record ContextInfo(
        String vendor,
        String renderer,
        String version,
        String shadingLanguageVersion,
        boolean software,
        Limits limits) {
    /**
     * Largest sizes and counts that a driver allows.
     *
     * @param textureSize texels along a side of a texture
     * @param colors color images of a render target that one draw can write
     * @param varyings scalar components that a vertex shader can pass to a fragment shader
     */
    public record Limits(
            int textureSize, int arrayLayers, int targetWidth, int targetHeight, int colors, int varyings) {}
}
