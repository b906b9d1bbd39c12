/**
 * Contexts and resources of OpenGL 3.3 core, through JOGL. Start at {@link jrtr.gl.RenderContext}.
 *
 * <p>Resources are written against {@code GlDevice}, which knows the thread, the limits and the open resources.
 */
package jrtr.gl;
