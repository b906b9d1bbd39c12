package jrtr;

/**
 * Names and versions of the driver and the device that render.
 *
 * @param renderer the device, such as {@code llvmpipe (LLVM 15.0.6, 256 bits)}
 * @param version of the graphics API and the driver
 * @param software true if the renderer's name is that of a software rasterizer
 */
public record ContextInfo(
        String vendor,
        String renderer,
        String version,
        String shadingLanguageVersion,
        boolean software,
        ContextLimits limits) {}
