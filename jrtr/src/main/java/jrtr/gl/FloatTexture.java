package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.BitSet;

/**
 * Texture of floats that shaders read, clamped at its edges. Values are row-major, channels interleaved: texel (x, y) of a layer starts at
 * {@code (y * width + x) * channels} and is {@code texelFetch(s, ivec2(x, y), 0)}. Row 0 of the array is texel row 0. NaN, infinities and
 * signed zeros arrive unchanged, denormals as far as the driver keeps them. All layers must be uploaded before a draw.
 */
public final class FloatTexture extends Texture {
    /** Formats of texels. A shader reads channels that a format lacks as 0, alpha as 1. */
    public enum Format {
        R32F(4, GL3.GL_R32F, GL3.GL_RED),
        RG32F(8, GL3.GL_RG32F, GL3.GL_RG),
        RGBA32F(16, GL3.GL_RGBA32F, GL3.GL_RGBA),
        RGBA16F(8, GL3.GL_RGBA16F, GL3.GL_RGBA);

        private final int bytesPerTexel;
        private final int internal;
        private final int pixels;

        Format(int bytesPerTexel, int internal, int pixels) {
            this.bytesPerTexel = bytesPerTexel;
            this.internal = internal;
            this.pixels = pixels;
        }
    }

    /** Interpolation between texel centers, which lie at (i + 1/2) / size. */
    public enum Filter {
        NEAREST,
        /** Bilinear within a layer. Weights may have as few as 8 bits on some hardware. */
        LINEAR
    }

    /** Shape, each side at least 1. An array is read by a {@code sampler2DArray}, another, which has one layer, by a {@code sampler2D}. */
    public record Spec(int width, int height, int layers, boolean array, Format format, Filter filter) {
        /** For a {@code sampler2D}, with {@link Filter#NEAREST}. */
        public static Spec flat(int width, int height, Format format) {
            return new Spec(width, height, 1, false, format, Filter.NEAREST);
        }

        /** For a {@code sampler2DArray}, with {@link Filter#NEAREST}. */
        public static Spec array(int width, int height, int layers, Format format) {
            return new Spec(width, height, layers, true, format, Filter.NEAREST);
        }

        public Spec with(Filter newFilter) {
            return new Spec(width, height, layers, array, format, newFilter);
        }
    }

    private final Spec spec;
    private final BitSet missingLayers = new BitSet();

    FloatTexture(GlDevice device, String label, Spec spec) {
        super(device, label, spec.array() ? GL3.GL_TEXTURE_2D_ARRAY : GL3.GL_TEXTURE_2D);
        this.spec = spec;
        missingLayers.set(0, spec.layers());
        orClose(() -> allocate(gl()), this::close);
    }

    private FloatTexture allocate(GL3 gl) {
        requireSides(spec.width(), spec.height(), spec.layers());
        int filter = spec.filter() == Filter.NEAREST ? GL3.GL_NEAREST : GL3.GL_LINEAR;
        begin(gl, GL3.GL_CLAMP_TO_EDGE, filter, filter);
        Format format = spec.format();
        double bytes = (double) format.bytesPerTexel * spec.width() * spec.height() * spec.layers();
        allocate(gl, format.internal, spec.width(), spec.height(), spec.layers(), format.pixels, GL3.GL_FLOAT, bytes);
        return this;
    }

    public void upload(float[] texels) {
        uploadLayer(0, FloatBuffer.wrap(texels));
    }

    /** Uploads width x height x channels floats to a layer, from 0. The buffer's position stays; direct buffers are not copied. */
    public void uploadLayer(int layer, FloatBuffer texels) {
        upload(layer, texels.slice(), GL3.GL_FLOAT);
    }

    /** Uploads a layer from numbers in the format's precision, IEEE 754 binary16 or binary32 in native byte order. */
    public void uploadLayer(int layer, ByteBuffer texels) {
        upload(layer, texels.slice(), spec.format() == Format.RGBA16F ? GL3.GL_HALF_FLOAT : GL3.GL_FLOAT);
    }

    private void upload(int layer, Buffer texels, int type) {
        GL3 gl = gl();
        bind(gl);
        int format = spec.format().pixels;
        if (spec.array()) {
            gl.glTexSubImage3D(glTarget, 0, 0, 0, layer, spec.width(), spec.height(), 1, format, type, texels);
        } else {
            gl.glTexSubImage2D(glTarget, 0, 0, 0, spec.width(), spec.height(), format, type, texels);
        }
        missingLayers.clear(layer);
        device().check(gl, "uploading layer " + layer + " of '" + label() + "'");
    }

    @Override
    void requireUploaded() {
        if (!missingLayers.isEmpty()) {
            throw new IllegalStateException("texture '" + label() + "' is drawn with before its layer "
                    + missingLayers.nextSetBit(0) + " was uploaded");
        }
    }

    public Spec spec() {
        return spec;
    }
}
