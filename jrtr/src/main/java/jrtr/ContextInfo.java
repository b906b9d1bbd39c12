package jrtr;

/**
 * Who renders.
 *
 * @param vendor the driver's maker
 * @param renderer the device, such as {@code llvmpipe (LLVM 15.0.6, 256 bits)}
 * @param version version of the graphics API and the driver
 * @param shadingLanguageVersion version of the shading language
 * @param software whether a processor renders rather than a graphics card, as far as the renderer's name tells
 * @param limits what the driver allows at most
 */
public record ContextInfo(
        String vendor,
        String renderer,
        String version,
        String shadingLanguageVersion,
        boolean software,
        ContextLimits limits) {}
