/** Contexts and resources of OpenGL 3.3 core, through JOGL. Start at {@link jrtr.gl.RenderContext}. */
package jrtr.gl;
