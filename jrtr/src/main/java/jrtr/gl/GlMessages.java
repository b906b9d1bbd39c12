package jrtr.gl;

import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLContext;
import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicReference;

/** The driver's debug output: to the log, and grave errors to the next {@link GlDevice#check}. */
final class GlMessages {
    private static final System.Logger LOGGER = System.getLogger("jrtr.gl");

    /** The first grave error since the last check; drivers may report from threads of their own. */
    private final AtomicReference<String> error = new AtomicReference<>();

    /** Starts listening; false where the driver has no debug output. */
    boolean listenTo(GLContext context, GL3 gl) {
        if (!context.isGLDebugMessageEnabled()) {
            return false;
        }
        // In the call that causes it, so that the log is in order.
        context.setGLDebugSynchronous(true);
        context.addGLDebugListener(
                event -> receive(event.getDbgSource(), event.getDbgType(), event.getDbgSeverity(), event.getDbgMsg()));
        return true;
    }

    void receive(int source, int type, int severity, String text) {
        String message = text.strip();
        boolean ofShader = source == GL2ES2.GL_DEBUG_SOURCE_SHADER_COMPILER;
        // A shader's log becomes an exception of its own, which has the author's files and lines.
        LOGGER.log(
                ofShader ? Level.DEBUG : level(severity), () -> "OpenGL " + GlNames.debugType(type) + ": " + message);
        boolean grave = type == GL2ES2.GL_DEBUG_TYPE_ERROR && severity == GL2ES2.GL_DEBUG_SEVERITY_HIGH;
        if (grave && !ofShader) {
            error.compareAndSet(null, message);
        }
    }

    /** The first grave error since the last call, or null. */
    String takeError() {
        return error.getAndSet(null);
    }

    private static Level level(int severity) {
        return switch (severity) {
            case GL2ES2.GL_DEBUG_SEVERITY_HIGH -> Level.WARNING;
            case GL2ES2.GL_DEBUG_SEVERITY_MEDIUM -> Level.INFO;
            default -> Level.DEBUG;
        };
    }
}
