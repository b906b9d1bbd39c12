package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Locale;
import jrtr.ContextLimits;
import jrtr.FloatFormat;
import jrtr.GraphicsException;
import jrtr.Wrap;

/** Checks and takes memory for textures. */
final class TextureMemory {
    private final GlDevice device;
    private final String label;

    TextureMemory(GlDevice device, String label) {
        this.device = device;
        this.label = label;
    }

    /** Throws if a side is beyond what the driver allows. */
    void requireSides(int width, int height, int layers) {
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

    /** Makes an empty texture and binds it. */
    int create(GL3 gl, int target, Wrap wrap) {
        int[] name = new int[1];
        gl.glGenTextures(1, name, 0);
        gl.glActiveTexture(GL3.GL_TEXTURE0);
        gl.glBindTexture(target, name[0]);
        int mode = wrap == Wrap.CLAMP ? GL3.GL_CLAMP_TO_EDGE : GL3.GL_REPEAT;
        gl.glTexParameteri(target, GL3.GL_TEXTURE_WRAP_S, mode);
        gl.glTexParameteri(target, GL3.GL_TEXTURE_WRAP_T, mode);
        return name[0];
    }

    /** Takes memory for level 0 of the bound texture, 2-D or an array of such. */
    void allocate(
            GL3 gl,
            int target,
            int internalFormat,
            int width,
            int height,
            int layers,
            int format,
            int type,
            long bytes) {
        if (target == GL3.GL_TEXTURE_2D) {
            gl.glTexImage2D(target, 0, internalFormat, width, height, 0, format, type, null);
        } else {
            gl.glTexImage3D(target, 0, internalFormat, width, height, layers, 0, format, type, null);
        }
        device.check(gl, String.format(Locale.ROOT, "taking %.1f MiB for '%s'", bytes / (double) (1 << 20), label));
    }

    static int internalFormat(FloatFormat format) {
        return switch (format) {
            case R32F -> GL3.GL_R32F;
            case RG32F -> GL3.GL_RG32F;
            case RGBA32F -> GL3.GL_RGBA32F;
            case RGBA16F -> GL3.GL_RGBA16F;
        };
    }

    static int pixelFormat(FloatFormat format) {
        return switch (format) {
            case R32F -> GL3.GL_RED;
            case RG32F -> GL3.GL_RG;
            case RGBA32F, RGBA16F -> GL3.GL_RGBA;
        };
    }
}
