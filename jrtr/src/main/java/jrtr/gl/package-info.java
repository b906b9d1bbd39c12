/**
 * Contexts and resources of OpenGL 3.3 core, through JOGL. Start at {@link jrtr.gl.RenderContext}.
 *
 * <p>Resources use {@code GlDevice}, which holds the owning thread, the limits and the open resources.
 */
package jrtr.gl;
