package jrtr.gl;

import jrtr.GraphicsException;
import jrtr.RenderContext;

/** Makes contexts. */
public final class RenderContexts {

    private RenderContexts() {}

    /**
     * A context without a window, for this thread. On Linux an X display is needed all the same (Xvfb will do).
     *
     * @throws GraphicsException if there is no display to connect to, or no OpenGL 3.3 core on it
     */
    public static RenderContext offscreen() {
        PrivateLibraries.prepare();
        DisplayWatch.start();
        return GlRenderContext.on(OffscreenSurface.create());
    }
}
