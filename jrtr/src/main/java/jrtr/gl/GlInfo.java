package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Locale;
import java.util.stream.Stream;
import jrtr.ContextInfo;
import jrtr.ContextLimits;

/** Asks a driver who it is and what it allows. */
final class GlInfo {

    private GlInfo() {}

    static ContextInfo of(GL3 gl, boolean debugOutputActive) {
        String renderer = gl.glGetString(GL3.GL_RENDERER);
        return new ContextInfo(
                gl.glGetString(GL3.GL_VENDOR),
                renderer,
                gl.glGetString(GL3.GL_VERSION),
                gl.glGetString(GL3.GL_SHADING_LANGUAGE_VERSION),
                isSoftware(renderer),
                debugOutputActive || gl.isExtensionAvailable("GL_KHR_debug"),
                debugOutputActive,
                timerQueryBits(gl),
                limits(gl));
    }

    private static ContextLimits limits(GL3 gl) {
        int[] viewport = new int[2];
        gl.glGetIntegerv(GL3.GL_MAX_VIEWPORT_DIMS, viewport, 0);
        return new ContextLimits(
                integer(gl, GL3.GL_MAX_TEXTURE_SIZE),
                integer(gl, GL3.GL_MAX_ARRAY_TEXTURE_LAYERS),
                integer(gl, GL3.GL_MAX_RENDERBUFFER_SIZE),
                viewport[0],
                viewport[1],
                integer(gl, GL3.GL_MAX_TEXTURE_IMAGE_UNITS),
                integer(gl, GL3.GL_MAX_FRAGMENT_UNIFORM_COMPONENTS),
                Math.min(integer(gl, GL3.GL_MAX_COLOR_ATTACHMENTS), integer(gl, GL3.GL_MAX_DRAW_BUFFERS)));
    }

    static boolean isSoftware(String renderer) {
        String name = renderer.toLowerCase(Locale.ROOT);
        return Stream.of("llvmpipe", "softpipe", "swrast", "swiftshader", "software rasterizer", "gdi generic")
                .anyMatch(name::contains);
    }

    private static int timerQueryBits(GL3 gl) {
        int[] bits = new int[1];
        gl.glGetQueryiv(GL3.GL_TIME_ELAPSED, GL3.GL_QUERY_COUNTER_BITS, bits, 0);
        return bits[0];
    }

    private static int integer(GL3 gl, int name) {
        int[] value = new int[1];
        gl.glGetIntegerv(name, value, 0);
        return value[0];
    }
}
