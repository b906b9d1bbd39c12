package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import jrtr.ContextInfo;
import jrtr.ContextLimits;
import jrtr.GraphicsException;

/** Shared state of one context: OpenGL functions, owning thread, limits, error checks and open resources. */
final class GlDevice {
    private final OffscreenSurface surface;
    private final Thread owner = Thread.currentThread();
    private final ContextInfo info;
    private final Set<Resource> resources = new LinkedHashSet<>();
    private boolean closed;

    GlDevice(OffscreenSurface surface) {
        this.surface = surface;
        this.info = info(surface.makeCurrent());
    }

    GL3 gl() {
        requireUsable();
        GL3 gl = surface.makeCurrent();
        DisplayFaults.blockIfExiting(gl);
        return gl;
    }

    void requireUsable() {
        requireOwner();
        if (closed) {
            throw new IllegalStateException("the render context is closed");
        }
    }

    void requireOwner() {
        if (Thread.currentThread() != owner) {
            throw new IllegalStateException("the render context belongs to thread '" + owner.getName()
                    + "' but was used from '" + Thread.currentThread().getName() + "'");
        }
    }

    ContextInfo info() {
        return info;
    }

    ContextLimits limits() {
        return info.limits();
    }

    void check(GL3 gl, String doing) {
        int error = gl.glGetError();
        if (error == GL3.GL_NO_ERROR) {
            return;
        }
        // A context has one flag per kind of error: clear all, so that the next check starts clean.
        for (int more = 0; more < 8 && gl.glGetError() != GL3.GL_NO_ERROR; more++) {}
        throw new GraphicsException(
                "OpenGL reported " + GlNames.error(error) + " while " + doing + GlNames.remedy(error));
    }

    void register(Resource resource) {
        resources.add(resource);
    }

    void unregister(Resource resource) {
        resources.remove(resource);
    }

    void close() {
        requireOwner();
        if (closed) {
            return;
        }
        try {
            GL3 gl = surface.makeCurrent();
            DisplayFaults.blockIfExiting(gl);
            List<Resource> open = new ArrayList<>(resources);
            for (int index = open.size() - 1; index >= 0; index--) {
                open.get(index).close();
            }
            // OpenGL keeps a deleted program alive while it is in use.
            gl.glUseProgram(0);
        } finally {
            closed = true;
            surface.destroy();
        }
    }

    private static ContextInfo info(GL3 gl) {
        String renderer = gl.glGetString(GL3.GL_RENDERER);
        return new ContextInfo(
                gl.glGetString(GL3.GL_VENDOR),
                renderer,
                gl.glGetString(GL3.GL_VERSION),
                gl.glGetString(GL3.GL_SHADING_LANGUAGE_VERSION),
                isSoftware(renderer),
                limits(gl));
    }

    private static ContextLimits limits(GL3 gl) {
        int[] viewport = new int[2];
        gl.glGetIntegerv(GL3.GL_MAX_VIEWPORT_DIMS, viewport, 0);
        int image = Math.min(integer(gl, GL3.GL_MAX_TEXTURE_SIZE), integer(gl, GL3.GL_MAX_RENDERBUFFER_SIZE));
        return new ContextLimits(
                integer(gl, GL3.GL_MAX_TEXTURE_SIZE),
                integer(gl, GL3.GL_MAX_ARRAY_TEXTURE_LAYERS),
                Math.min(image, viewport[0]),
                Math.min(image, viewport[1]),
                Math.min(integer(gl, GL3.GL_MAX_COLOR_ATTACHMENTS), integer(gl, GL3.GL_MAX_DRAW_BUFFERS)),
                integer(gl, GL3.GL_MAX_VARYING_COMPONENTS));
    }

    private static boolean isSoftware(String renderer) {
        String name = renderer.toLowerCase(Locale.ROOT);
        return Stream.of("llvmpipe", "softpipe", "swrast", "swiftshader", "software rasterizer", "gdi generic")
                .anyMatch(name::contains);
    }

    private static int integer(GL3 gl, int name) {
        int[] value = new int[1];
        gl.glGetIntegerv(name, value, 0);
        return value[0];
    }
}
