/**
 * The engine on JOGL: OpenGL 3.3 core or later. {@link jrtr.gl.RenderContexts} makes contexts; all else is private.
 *
 * <p>Resources are written against {@code GlDevice}, which knows the thread, the limits and the open resources, and the
 * device against {@code GlSurface}, the only part that differs between an offscreen context and one in a window.
 */
package jrtr.gl;
