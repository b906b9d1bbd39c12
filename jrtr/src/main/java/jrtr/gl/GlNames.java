package jrtr.gl;

import com.jogamp.opengl.GL3;

/** Names of OpenGL's error and status codes. */
final class GlNames {

    private GlNames() {}

    static String error(int code) {
        return switch (code) {
            case GL3.GL_INVALID_ENUM -> "GL_INVALID_ENUM";
            case GL3.GL_INVALID_VALUE -> "GL_INVALID_VALUE";
            case GL3.GL_INVALID_OPERATION -> "GL_INVALID_OPERATION";
            case GL3.GL_INVALID_FRAMEBUFFER_OPERATION -> "GL_INVALID_FRAMEBUFFER_OPERATION";
            case GL3.GL_OUT_OF_MEMORY -> "GL_OUT_OF_MEMORY";
            default -> "error " + hex(code);
        };
    }

    static String remedy(int code) {
        return code == GL3.GL_OUT_OF_MEMORY ? ". Use a smaller picture, mesh or texture" : "";
    }

    static String framebufferStatus(int code) {
        return switch (code) {
            case GL3.GL_FRAMEBUFFER_UNSUPPORTED -> "this combination of images is not supported by the driver";
            case GL3.GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT -> "an image cannot be drawn to";
            default -> "status " + hex(code);
        };
    }

    static String hex(int code) {
        return "0x" + Integer.toHexString(code);
    }
}
