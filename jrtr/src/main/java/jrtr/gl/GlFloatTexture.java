package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.ShortBuffer;
import java.util.BitSet;
import jrtr.Filter;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.Wrap;

/** A float texture, 2-D or 2-D array. */
final class GlFloatTexture extends GlResource implements FloatTexture, GlTexture {
    private final FloatTextureSpec spec;
    private final int target;
    private final int name;
    private final BitSet missingLayers = new BitSet();

    private GlFloatTexture(GlDevice device, String label, FloatTextureSpec spec, int target, int name) {
        super(device, label);
        this.spec = spec;
        this.target = target;
        this.name = name;
        missingLayers.set(0, spec.layers());
    }

    static GlFloatTexture create(GlDevice device, String label, FloatTextureSpec spec) {
        GL3 gl = device.gl();
        TextureMemory memory = new TextureMemory(device, label);
        memory.requireSides(spec.width(), spec.height(), spec.layers());
        int target = spec.array() ? GL3.GL_TEXTURE_2D_ARRAY : GL3.GL_TEXTURE_2D;
        int name = memory.create(gl, target, Wrap.CLAMP);
        GlFloatTexture texture = new GlFloatTexture(device, label, spec, target, name);
        try {
            texture.allocate(gl, memory);
            return texture;
        } catch (RuntimeException failure) {
            texture.close();
            throw failure;
        }
    }

    private void allocate(GL3 gl, TextureMemory memory) {
        int filter = spec.filter() == Filter.NEAREST ? GL3.GL_NEAREST : GL3.GL_LINEAR;
        gl.glTexParameteri(target, GL3.GL_TEXTURE_MIN_FILTER, filter);
        gl.glTexParameteri(target, GL3.GL_TEXTURE_MAG_FILTER, filter);
        gl.glTexParameteri(target, GL3.GL_TEXTURE_MAX_LEVEL, 0);
        int internalFormat = TextureMemory.internalFormat(spec.format());
        int format = TextureMemory.pixelFormat(spec.format());
        long bytes = spec.format().bytesPerChannel() * spec.floats();
        memory.allocate(
                gl, target, internalFormat, spec.width(), spec.height(), spec.layers(), format, GL3.GL_FLOAT, bytes);
    }

    @Override
    public void upload(float[] texels) {
        requireLength(texels.length, spec.floats());
        int length = Math.toIntExact(spec.floatsPerLayer());
        for (int layer = 0; layer < spec.layers(); layer++) {
            put(layer, FloatBuffer.wrap(texels).slice(layer * length, length), GL3.GL_FLOAT);
        }
        device().check(gl(), "uploading '" + label() + "'");
    }

    @Override
    public void uploadLayer(int layer, FloatBuffer texels) {
        requireLayer(layer, texels.remaining());
        put(layer, texels.slice(), GL3.GL_FLOAT);
        device().check(gl(), "uploading layer " + layer + " of '" + label() + "'");
    }

    @Override
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
        int format = TextureMemory.pixelFormat(spec.format());
        gl.glActiveTexture(GL3.GL_TEXTURE0);
        gl.glBindTexture(target, name);
        gl.glPixelStorei(GL3.GL_UNPACK_ALIGNMENT, 4);
        if (spec.array()) {
            gl.glTexSubImage3D(target, 0, 0, 0, layer, spec.width(), spec.height(), 1, format, type, texels);
        } else {
            gl.glTexSubImage2D(target, 0, 0, 0, spec.width(), spec.height(), format, type, texels);
        }
        missingLayers.clear(layer);
    }

    @Override
    public void requireReadyFor(GlDevice user) {
        requireUsableBy(user);
        if (!missingLayers.isEmpty()) {
            throw new IllegalStateException("texture '" + label() + "' is drawn with before its layer "
                    + missingLayers.nextSetBit(0) + " was uploaded");
        }
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteTextures(1, new int[] {name}, 0);
    }

    @Override
    public FloatTextureSpec spec() {
        return spec;
    }

    @Override
    public boolean isArray() {
        return spec.array();
    }

    @Override
    public int glTarget() {
        return target;
    }

    @Override
    public int glName() {
        return name;
    }
}
