/**
 * jrtr, a small real-time rendering engine. This package is its vocabulary: values that do not name
 * OpenGL.
 *
 * <p>The rooms:
 *
 * <ul>
 *   <li>{@code jrtr.gl}: contexts, programs, textures and targets, on JOGL. Start at {@link jrtr.gl.RenderContext}.
 *   <li>{@code jrtr.glsl}: shader text before any driver sees it, that is include expansion, source maps and the reading
 *       of compilers' logs. Plain string code.
 *   <li>{@link jrtr.scene}: the scene graph (groups, shapes, lights, camera, render queue) and its renderer; stands on
 *       {@code jrtr.gl}. Start at {@link jrtr.scene.SceneRenderer}.
 * </ul>
 *
 * <p>Conventions: images and rectangles are counted from the top left, row 0 is the top one; the implementation turns
 * that into OpenGL's bottom-up rows. A resource belongs to the context that made it, is freed by its own {@code
 * close()} or by the context's, and may be used on the context's thread only.
 *
 * <p>Failures: {@link jrtr.GraphicsException} for what the machine, the driver or a shader cannot do; {@link
 * IllegalArgumentException} and {@link IllegalStateException} for misuse by the calling program (a wrong array length, a
 * closed resource, a foreign thread).
 */
package jrtr;
