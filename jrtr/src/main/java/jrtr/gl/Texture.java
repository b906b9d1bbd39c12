package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Locale;
import jrtr.ContextLimits;
import jrtr.GraphicsException;
import jrtr.Wrap;

/** Texture that a {@link Binding} binds to a sampler by name. */
public abstract class Texture extends Resource {
    /** GL_TEXTURE_2D or GL_TEXTURE_2D_ARRAY. */
    final int glTarget;

    private final int[] name = new int[1];

    Texture(GlDevice device, String label, int glTarget) {
        super(device, label);
        this.glTarget = glTarget;
    }

    abstract void requireUploaded();

    static void requireSides(GlDevice device, String label, int width, int height, int layers) {
        ContextLimits limits = device.limits();
        if (width > limits.textureSize() || height > limits.textureSize()) {
            throw new GraphicsException("texture '" + label + "' needs " + width + " x " + height
                    + " texels but this driver allows at most " + limits.textureSize() + " along a side ("
                    + device.info().renderer() + ")");
        }
        if (layers > limits.arrayLayers()) {
            throw new GraphicsException("texture '" + label + "' needs " + layers
                    + " layers but this driver allows at most " + limits.arrayLayers() + " ("
                    + device.info().renderer() + ")");
        }
    }

    /** Creates and binds the texture and sets its sampling; it has no mipmaps if both filters are equal. */
    final void begin(GL3 gl, Wrap wrap, int minified, int magnified) {
        gl.glGenTextures(1, name, 0);
        bind(gl);
        int mode = wrap == Wrap.CLAMP ? GL3.GL_CLAMP_TO_EDGE : GL3.GL_REPEAT;
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_WRAP_S, mode);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_WRAP_T, mode);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_MIN_FILTER, minified);
        gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_MAG_FILTER, magnified);
        if (minified == magnified) {
            gl.glTexParameteri(glTarget, GL3.GL_TEXTURE_MAX_LEVEL, 0);
        }
    }

    final void allocate(GL3 gl, int internal, int width, int height, int layers, int format, int type, long bytes) {
        if (isArray()) {
            gl.glTexImage3D(glTarget, 0, internal, width, height, layers, 0, format, type, null);
        } else {
            gl.glTexImage2D(glTarget, 0, internal, width, height, 0, format, type, null);
        }
        device().check(gl, String.format(Locale.ROOT, "taking %.1f MiB for '%s'", bytes / (double) (1 << 20), label()));
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
