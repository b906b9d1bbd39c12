/**
 * jrtr, a small real-time scene-graph engine. This package has the values that the engine's packages share; they do not depend on OpenGL.
 * Start at {@link jrtr.gl.RenderContext}, {@link jrtr.scene.Node} and {@link jrtr.scene.RenderPass}.
 *
 * <p>Conventions: images and rectangles are counted from the top left, row 0 is the top one; the implementation converts to OpenGL's
 * bottom-up rows. A resource belongs to the context that made it, is freed by its own {@code close()} or by the context's, and may be used
 * on the context's thread only.
 *
 * <p>Failures: {@link jrtr.GraphicsException} for limits of the machine, the driver or a shader; {@link IllegalArgumentException} and
 * {@link IllegalStateException} for misuse by the caller (a wrong array length, a closed resource, a foreign thread).
 */
package jrtr;
