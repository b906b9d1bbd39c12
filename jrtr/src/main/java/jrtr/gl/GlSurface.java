package jrtr.gl;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLContext;

/** Where a context comes from: nowhere visible, or later a window. */
interface GlSurface {

    /** The context, for its debug listeners and its version. */
    GLContext context();

    /** Makes the context current on this thread if it is not, and gives its functions. */
    GL3 makeCurrent();

    /** Ends the context and what was made for it. Called once. */
    void destroy();
}
