package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Locale;
import java.util.stream.Stream;
import jrtr.ContextInfo;
import jrtr.ContextLimits;

/** Asks a driver who it is and what it allows. */
final class GlInfo {

    private GlInfo() {}

    static ContextInfo of(GL3 gl) {
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
