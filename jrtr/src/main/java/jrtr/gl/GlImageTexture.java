package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import jrtr.ColorEncoding;
import jrtr.ImageTexture;
import jrtr.ImageTextureSpec;

/** An 8-bit RGBA texture with mipmaps. */
final class GlImageTexture extends GlResource implements ImageTexture, GlTexture {
    private static final int TARGET = GL3.GL_TEXTURE_2D;

    private final ImageTextureSpec spec;
    private final int name;
    private boolean uploaded;

    private GlImageTexture(GlDevice device, String label, ImageTextureSpec spec, int name) {
        super(device, label);
        this.spec = spec;
        this.name = name;
    }

    static GlImageTexture create(GlDevice device, String label, ImageTextureSpec spec) {
        GL3 gl = device.gl();
        TextureMemory memory = new TextureMemory(device, label);
        memory.requireSides(spec.width(), spec.height(), 1);
        GlImageTexture texture = new GlImageTexture(device, label, spec, memory.create(gl, TARGET, spec.wrap()));
        try {
            gl.glTexParameteri(TARGET, GL3.GL_TEXTURE_MIN_FILTER, GL3.GL_LINEAR_MIPMAP_LINEAR);
            gl.glTexParameteri(TARGET, GL3.GL_TEXTURE_MAG_FILTER, GL3.GL_LINEAR);
            int format = spec.encoding() == ColorEncoding.SRGB ? GL3.GL_SRGB8_ALPHA8 : GL3.GL_RGBA8;
            memory.allocate(
                    gl,
                    TARGET,
                    format,
                    spec.width(),
                    spec.height(),
                    1,
                    GL3.GL_RGBA,
                    GL3.GL_UNSIGNED_BYTE,
                    spec.bytes());
            return texture;
        } catch (RuntimeException failure) {
            texture.close();
            throw failure;
        }
    }

    @Override
    public void upload(byte[] rgba) {
        if (rgba.length != spec.bytes()) {
            throw new IllegalArgumentException("image '" + label() + "' of " + spec.width() + " x " + spec.height()
                    + " texels needs " + spec.bytes() + " bytes, not " + rgba.length);
        }
        GL3 gl = gl();
        gl.glActiveTexture(GL3.GL_TEXTURE0);
        gl.glBindTexture(TARGET, name);
        gl.glPixelStorei(GL3.GL_UNPACK_ALIGNMENT, 4);
        gl.glTexSubImage2D(
                TARGET,
                0,
                0,
                0,
                spec.width(),
                spec.height(),
                GL3.GL_RGBA,
                GL3.GL_UNSIGNED_BYTE,
                ByteBuffer.wrap(bottomRowFirst(rgba)));
        gl.glGenerateMipmap(TARGET);
        device().check(gl, "uploading '" + label() + "'");
        uploaded = true;
    }

    private byte[] bottomRowFirst(byte[] rgba) {
        byte[] flipped = new byte[rgba.length];
        int rowBytes = 4 * spec.width();
        for (int row = 0; row < spec.height(); row++) {
            System.arraycopy(rgba, row * rowBytes, flipped, (spec.height() - 1 - row) * rowBytes, rowBytes);
        }
        return flipped;
    }

    @Override
    public void requireReadyFor(GlDevice user) {
        requireUsableBy(user);
        if (!uploaded) {
            throw new IllegalStateException("image '" + label() + "' is drawn with before it was uploaded");
        }
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteTextures(1, new int[] {name}, 0);
    }

    @Override
    public boolean isArray() {
        return false;
    }

    @Override
    public int glTarget() {
        return TARGET;
    }

    @Override
    public int glName() {
        return name;
    }
}
