package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Locale;
import jrtr.gl.RenderContext.ContextInfo;

/** Texture that a draw binds to a sampler by name. */
public class Texture extends Resource {
    /** GL_TEXTURE_2D or GL_TEXTURE_2D_ARRAY. */
    final int glTarget;

    private final int[] name = new int[1];

    Texture(GlDevice device, String label, int glTarget) {
        super(device, label);
        this.glTarget = glTarget;
    }

    /** Throws if a draw with this texture would read undefined texels. */
    void requireUploaded() {}

    final void requireSides(int width, int height, int layers) {
        ContextInfo.Limits limits = device().info().limits();
        if (width > limits.textureSize() || height > limits.textureSize()) {
            throw device().beyondLimit(
                            "texture '" + label() + "' needs " + width + " x " + height + " texels",
                            limits.textureSize() + " along a side");
        }
        if (layers > limits.arrayLayers()) {
            throw device().beyondLimit("texture '" + label() + "' needs " + layers + " layers", limits.arrayLayers());
        }
    }

    /** Creates and binds the texture and sets its sampling; it has no mipmaps if both filters are equal. */
    final void begin(GL3 gl, int wrap, int minified, int magnified) {
        gl.glGenTextures(1, name, 0);
        bind(gl);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_WRAP_S, wrap);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_WRAP_T, wrap);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_MIN_FILTER, minified);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_MAG_FILTER, magnified);
        if (minified == magnified) {
            gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_MAX_LEVEL, 0);
        }
    }

    final void allocate(GL3 gl, int internal, int width, int height, int layers, int format, int type, double bytes) {
        if (isArray()) {
            gl.glTexImage3D(glTarget, 0, internal, width, height, layers, 0, format, type, null);
        } else {
            gl.glTexImage2D(glTarget, 0, internal, width, height, 0, format, type, null);
        }
        device().check(gl, String.format(Locale.ROOT, "taking %.1f MiB for '%s'", bytes / (1 << 20), label()));
    }

    final void bind(GL3 gl) {
        gl.glActiveTexture(GL3.GL_TEXTURE0);
        gl.glBindTexture(glTarget, name[0]);
        gl.glPixelStorei(GL3.GL_UNPACK_ALIGNMENT, 4);
    }

    final int glName() {
        return name[0];
    }

    /** True for a {@code sampler2DArray}, also with one layer. */
    final boolean isArray() {
        return glTarget == GL3.GL_TEXTURE_2D_ARRAY;
    }

    @Override
    final void delete(GL3 gl) {
        gl.glDeleteTextures(1, name, 0);
    }
}
