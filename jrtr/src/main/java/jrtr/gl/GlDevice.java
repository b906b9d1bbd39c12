package jrtr.gl;

import com.jogamp.common.util.VersionNumber;
import com.jogamp.nativewindow.AbstractGraphicsDevice;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLDrawable;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import java.awt.AWTError;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext.ContextInfo;

/** OpenGL context on a dummy drawable, with its owning thread, limits, error checks and open resources. */
final class GlDevice {
    private static final String[] CORE_PROFILES = {GLProfile.GL4, GLProfile.GL3};
    private static final VersionNumber OLDEST_VERSION = new VersionNumber(3, 3, 0);

    private final GLDrawable drawable;
    private final GLContext context;
    private final Thread owner = Thread.currentThread();
    private final Deque<Resource> resources = new ArrayDeque<>();
    private ContextInfo info;
    private boolean closed;

    private GlDevice(GLDrawable drawable) {
        this.drawable = drawable;
        this.context = drawable.createContext(null);
    }

    static GlDevice open() {
        DisplayFaults.prepare();
        // The connection stays open until there is a context: without -noreset, X servers reset when none is left.
        AbstractGraphicsDevice display = connectToDisplay();
        try {
            return create();
        } catch (RuntimeException | LinkageError failure) {
            throw new GraphicsException(
                    "no OpenGL 3.3 core context on display " + System.getenv("DISPLAY") + " (" + reason(failure)
                            + "). Install a driver, or Mesa's software renderer (libgl1-mesa-dri, libgl1); a display needs 24 bits a pixel",
                    failure);
        } finally {
            display.close();
        }
    }

    /** A step of its own, so that a missing display and a missing driver have separate messages. */
    private static AbstractGraphicsDevice connectToDisplay() {
        try {
            NativeWindowFactory.initSingleton();
            return NativeWindowFactory.createDevice(null, true);
        } catch (RuntimeException | AWTError failure) {
            String name = System.getenv("DISPLAY");
            boolean isSet = name != null && !name.isBlank();
            throw new GraphicsException(
                    "no display: " + (isSet ? "DISPLAY=" + name + " does not answer" : "DISPLAY is not set")
                            + ". Set DISPLAY to a running X server, or start one without a screen: Xvfb :1 -noreset & export DISPLAY=:1",
                    failure);
        } catch (LinkageError failure) {
            throw new GraphicsException(
                    "JOGL's native libraries cannot be loaded: " + reason(failure)
                            + ". The folder for temporary files (java.io.tmpdir) needs free space, programs must be"
                            + " allowed to run there, and the X11 libraries must be installed",
                    failure);
        }
    }

    private static GlDevice create() {
        GLProfile profile = GLProfile.get(CORE_PROFILES, true);
        GLCapabilities capabilities = new GLCapabilities(profile);
        capabilities.setOnscreen(false);
        capabilities.setDoubleBuffered(false);
        GLDrawableFactory factory = GLDrawableFactory.getFactory(profile);
        GLDrawable drawable = factory.createDummyDrawable(factory.getDefaultDevice(), true, capabilities, null);
        if (!drawable.isRealized()) {
            drawable.setRealized(true);
        }
        GlDevice device = new GlDevice(drawable);
        return Resource.orClose(device::start, device::release);
    }

    private GlDevice start() {
        GL3 gl = makeCurrent();
        VersionNumber version = context.getGLVersionNumber();
        if (version.compareTo(OLDEST_VERSION) < 0) {
            throw new GLException("the driver has OpenGL " + version + " only");
        }
        info = info(gl);
        return this;
    }

    private GL3 makeCurrent() {
        if (!context.isCurrent() && context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
            throw new GLException("the context cannot be made current");
        }
        return context.getGL().getGL3();
    }

    private void release() {
        try {
            context.destroy();
        } finally {
            drawable.setRealized(false);
        }
    }

    private static String reason(Throwable failure) {
        if (failure.getMessage() == null) {
            return failure.getClass().getSimpleName();
        }
        // JOGL's messages show objects with all their fields, in nested brackets: shorten these to the type.
        return failure.getMessage().replaceAll("(Device|Screen|Configuration|Drawable)\\[.*]", "$1");
    }

    GL3 gl() {
        requireOwner();
        if (closed) {
            throw new IllegalStateException("the render context is closed");
        }
        GL3 gl = makeCurrent();
        DisplayFaults.blockIfExiting(gl);
        return gl;
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

    void check(GL3 gl, String doing) {
        int error = gl.glGetError();
        if (error == GL3.GL_NO_ERROR) {
            return;
        }
        // A context has one flag per kind of error: clear all, so that the next check starts clean.
        for (int more = 0; more < 8 && gl.glGetError() != GL3.GL_NO_ERROR; more++) {}
        throw new GraphicsException("OpenGL reported " + name(error) + " while " + doing
                + (error == GL3.GL_OUT_OF_MEMORY ? ". Use a smaller picture, mesh or texture" : ""));
    }

    private static String name(int error) {
        return switch (error) {
            case GL3.GL_INVALID_ENUM -> "GL_INVALID_ENUM";
            case GL3.GL_INVALID_VALUE -> "GL_INVALID_VALUE";
            case GL3.GL_INVALID_OPERATION -> "GL_INVALID_OPERATION";
            case GL3.GL_INVALID_FRAMEBUFFER_OPERATION -> "GL_INVALID_FRAMEBUFFER_OPERATION";
            case GL3.GL_OUT_OF_MEMORY -> "GL_OUT_OF_MEMORY";
            default -> "error 0x" + Integer.toHexString(error);
        };
    }

    GraphicsException beyondLimit(String need, Object limit) {
        return new GraphicsException(need + " but this driver allows at most " + limit + " (" + info.renderer() + ")");
    }

    /** Returns the open resources, the newest last; {@link #close} closes them. */
    Deque<Resource> resources() {
        return resources;
    }

    void close() {
        requireOwner();
        if (closed) {
            return;
        }
        try {
            GL3 gl = gl();
            while (!resources.isEmpty()) {
                resources.getLast().close();
            }
            // OpenGL keeps a deleted program alive while it is in use.
            gl.glUseProgram(0);
        } finally {
            closed = true;
            release();
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

    private static ContextInfo.Limits limits(GL3 gl) {
        int[] viewport = new int[2];
        gl.glGetIntegerv(GL3.GL_MAX_VIEWPORT_DIMS, viewport, 0);
        int image = Math.min(integer(gl, GL3.GL_MAX_TEXTURE_SIZE), integer(gl, GL3.GL_MAX_RENDERBUFFER_SIZE));
        return new ContextInfo.Limits(
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
