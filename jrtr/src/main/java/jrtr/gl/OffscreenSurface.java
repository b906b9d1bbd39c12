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
import jrtr.GraphicsException;

/** OpenGL context on a dummy drawable; all drawing goes to {@link FloatTarget}s. */
final class OffscreenSurface {
    private static final String[] CORE_PROFILES = {GLProfile.GL4, GLProfile.GL3};

    private static final VersionNumber OLDEST_VERSION = new VersionNumber(3, 3, 0);

    static {
        // At exit, this hook waits for threads that are opening a context. It runs before JOGL's shutdown code, which
        // would wait forever
        // for a helper thread that JOGL is then starting.
        NativeWindowFactory.addCustomShutdownHook(true, DisplayFaults::awaitRest);
    }

    private final GLDrawable drawable;
    private final GLContext context;

    private OffscreenSurface(GLDrawable drawable, GLContext context) {
        this.drawable = drawable;
        this.context = context;
    }

    static OffscreenSurface create() {
        DisplayFaults.registerDrawingThread();
        try {
            return connect();
        } catch (RuntimeException | Error failure) {
            DisplayFaults.unregisterDrawingThread();
            throw failure;
        } finally {
            DisplayFaults.finishOpening();
        }
    }

    private static OffscreenSurface connect() {
        // The connection stays open until there is a context: without the option -noreset, X servers reset when their
        // last client goes.
        AbstractGraphicsDevice display = connectToDisplay();
        try {
            return open();
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
            throw new GraphicsException(
                    "no display: " + displayName()
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

    private static String displayName() {
        String name = System.getenv("DISPLAY");
        return name == null || name.isBlank() ? "DISPLAY is not set" : "DISPLAY=" + name + " does not answer";
    }

    private static OffscreenSurface open() {
        GLProfile profile = GLProfile.get(CORE_PROFILES, true);
        GLCapabilities capabilities = new GLCapabilities(profile);
        capabilities.setOnscreen(false);
        capabilities.setDoubleBuffered(false);
        GLDrawableFactory factory = GLDrawableFactory.getFactory(profile);
        GLDrawable drawable = factory.createDummyDrawable(factory.getDefaultDevice(), true, capabilities, null);
        if (!drawable.isRealized()) {
            drawable.setRealized(true);
        }
        OffscreenSurface surface = new OffscreenSurface(drawable, drawable.createContext(null));
        try {
            surface.makeCurrent();
            VersionNumber version = surface.context.getGLVersionNumber();
            if (version.compareTo(OLDEST_VERSION) < 0) {
                throw new GLException("the driver has OpenGL " + version + " only");
            }
            return surface;
        } catch (RuntimeException failure) {
            surface.release();
            throw failure;
        }
    }

    GL3 makeCurrent() {
        if (!context.isCurrent() && context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
            throw new GLException("the context cannot be made current");
        }
        return context.getGL().getGL3();
    }

    /** Must be called only once. */
    void destroy() {
        try {
            release();
        } finally {
            DisplayFaults.unregisterDrawingThread();
        }
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
}
