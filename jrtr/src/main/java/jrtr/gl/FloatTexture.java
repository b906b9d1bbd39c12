package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.ShortBuffer;
import java.util.BitSet;
import jrtr.Filter;
import jrtr.FloatTextureSpec;
import jrtr.Wrap;

/**
 * Texture of floats that shaders read. Values are row-major, channels interleaved: texel (x, y) of a layer starts at {@code (y
 * * width + x) * channels} and is {@code texelFetch(s, ivec2(x, y), 0)}. Row 0 of the array is texel row 0. NaN,
 * infinities and signed zeros arrive unchanged, denormals as far as the driver keeps them.
 *
 * <p>Every layer must be uploaded once before the texture is drawn with.
 */
public final class FloatTexture extends Texture {
    private final FloatTextureSpec spec;
    private final BitSet missingLayers = new BitSet();

    private FloatTexture(GlDevice device, String label, FloatTextureSpec spec) {
        super(device, label, spec.array() ? GL3.GL_TEXTURE_2D_ARRAY : GL3.GL_TEXTURE_2D);
        this.spec = spec;
        missingLayers.set(0, spec.layers());
    }

    static FloatTexture create(GlDevice device, String label, FloatTextureSpec spec) {
        GL3 gl = device.gl();
        requireSides(device, label, spec.width(), spec.height(), spec.layers());
        return initialize(new FloatTexture(device, label, spec), texture -> texture.allocate(gl));
    }

    private void allocate(GL3 gl) {
        int filter = spec.filter() == Filter.NEAREST ? GL3.GL_NEAREST : GL3.GL_LINEAR;
        begin(gl, Wrap.CLAMP, filter, filter);
        int internalFormat = switch (spec.format()) {
            case R32F -> GL3.GL_R32F;
            case RG32F -> GL3.GL_RG32F;
            case RGBA32F -> GL3.GL_RGBA32F;
            case RGBA16F -> GL3.GL_RGBA16F;
        };
        long bytes = spec.format().bytesPerChannel() * spec.floats();
        allocate(gl, internalFormat, spec.width(), spec.height(), spec.layers(), pixelFormat(), GL3.GL_FLOAT, bytes);
    }

    private int pixelFormat() {
        return switch (spec.format()) {
            case R32F -> GL3.GL_RED;
            case RG32F -> GL3.GL_RG;
            case RGBA32F, RGBA16F -> GL3.GL_RGBA;
        };
    }

    /**
     * Uploads all layers.
     *
     * @param texels width x height x layers x channels floats
     * @throws IllegalArgumentException if there are more or fewer
     */
    public void upload(float[] texels) {
        requireLength(texels.length, spec.floats());
        int length = Math.toIntExact(spec.floatsPerLayer());
        for (int layer = 0; layer < spec.layers(); layer++) {
            put(layer, FloatBuffer.wrap(texels).slice(layer * length, length), GL3.GL_FLOAT);
        }
        device().check(gl(), "uploading '" + label() + "'");
    }

    /**
     * Uploads one layer.
     *
     * @param layer from 0
     * @param texels width x height x channels floats, from the buffer's position, which does not change, to its limit. Direct buffers are
     *     not copied.
     * @throws IllegalArgumentException if the number of floats differs or there is no such layer
     */
    public void uploadLayer(int layer, FloatBuffer texels) {
        requireLayer(layer, texels.remaining());
        put(layer, texels.slice(), GL3.GL_FLOAT);
        device().check(gl(), "uploading layer " + layer + " of '" + label() + "'");
    }

    /**
     * Uploads one layer of a texture with floats of 16 bits.
     *
     * @param texels width x height x channels bit patterns of IEEE 754 binary16 floats, from the buffer's position, which does not change,
     *     to its limit
     * @throws IllegalArgumentException if the number of floats differs, there is no such layer, or the texture has floats of 32 bits
     */
    public void uploadLayer(int layer, ShortBuffer texels) {
        if (spec.format().bytesPerChannel() != Short.BYTES) {
            throw new IllegalArgumentException("texture '" + label() + "' has floats of 32 bits, not of 16");
        }
        requireLayer(layer, texels.remaining());
        put(layer, texels.slice(), GL3.GL_HALF_FLOAT);
        device().check(gl(), "uploading layer " + layer + " of '" + label() + "'");
    }

    private void requireLayer(int layer, int floats) {
        if (layer < 0 || layer >= spec.layers()) {
            throw new IllegalArgumentException(
                    "texture '" + label() + "' has layers 0 to " + (spec.layers() - 1) + ", not " + layer);
        }
        requireLength(floats, spec.floatsPerLayer());
    }

    private void requireLength(int given, long needed) {
        if (given != needed) {
            throw new IllegalArgumentException("texture '" + label() + "' of " + spec.width() + " x " + spec.height()
                    + " x " + spec.layers() + " texels in " + spec.format() + " needs " + needed + " floats here, not "
                    + given);
        }
    }

    private void put(int layer, Buffer texels, int type) {
        GL3 gl = gl();
        bind(gl);
        int format = pixelFormat();
        if (spec.array()) {
            gl.glTexSubImage3D(glTarget, 0, 0, 0, layer, spec.width(), spec.height(), 1, format, type, texels);
        } else {
            gl.glTexSubImage2D(glTarget, 0, 0, 0, spec.width(), spec.height(), format, type, texels);
        }
        missingLayers.clear(layer);
    }

    @Override
    void requireUploaded() {
        if (!missingLayers.isEmpty()) {
            throw new IllegalStateException("texture '" + label() + "' is drawn with before its layer "
                    + missingLayers.nextSetBit(0) + " was uploaded");
        }
    }

    public FloatTextureSpec spec() {
        return spec;
    }
}
