/**
 * What lives on the graphics card, on JOGL: OpenGL 3.3 core or later. Start at {@link jrtr.gl.RenderContext}.
 *
 * <p>Resources are written against {@code GlDevice}, which knows the thread, the limits and the open resources.
 */
package jrtr.gl;
