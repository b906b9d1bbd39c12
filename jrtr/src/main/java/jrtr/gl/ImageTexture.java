package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import jrtr.ColorEncoding;
import jrtr.ImageTextureSpec;

/**
 * 8-bit RGBA texture ({@code sampler2D}) with trilinear filtering; mipmaps are averaged in linear light. Texture coordinate (0, 0) is
 * the picture's bottom left corner, (1, 1) the top right, as in mesh files.
 */
public final class ImageTexture extends Texture {
    private final ImageTextureSpec spec;
    private boolean uploaded;

    private ImageTexture(GlDevice device, String label, ImageTextureSpec spec) {
        super(device, label, GL3.GL_TEXTURE_2D);
        this.spec = spec;
    }

    static ImageTexture create(GlDevice device, String label, ImageTextureSpec spec) {
        GL3 gl = device.gl();
        requireSides(device, label, spec.width(), spec.height(), 1);
        return initialize(new ImageTexture(device, label, spec), texture -> texture.allocate(gl));
    }

    private void allocate(GL3 gl) {
        begin(gl, spec.wrap(), GL3.GL_LINEAR_MIPMAP_LINEAR, GL3.GL_LINEAR);
        allocate(gl, internalFormat(), spec.width(), spec.height(), 1, GL3.GL_RGBA, GL3.GL_UNSIGNED_BYTE, spec.bytes());
    }

    private int internalFormat() {
        return spec.encoding() == ColorEncoding.SRGB ? GL3.GL_SRGB8_ALPHA8 : GL3.GL_RGBA8;
    }

    private void put(GL3 gl, int number, MipLevel level) {
        ByteBuffer texels = ByteBuffer.wrap(level.rgba());
        gl.glTexImage2D(
                glTarget,
                number,
                internalFormat(),
                level.width(),
                level.height(),
                0,
                GL3.GL_RGBA,
                GL3.GL_UNSIGNED_BYTE,
                texels);
    }

    /**
     * Uploads the picture and its mipmaps.
     *
     * @param rgba 4 x width x height bytes, red first, row 0 the picture's top
     * @throws IllegalArgumentException if {@code rgba} has any other length
     */
    public void upload(byte[] rgba) {
        if (rgba.length != spec.bytes()) {
            throw new IllegalArgumentException("image '" + label() + "' of " + spec.width() + " x " + spec.height()
                    + " texels needs " + spec.bytes() + " bytes, not " + rgba.length);
        }
        GL3 gl = gl();
        bind(gl);
        MipLevel level = new MipLevel(spec.width(), spec.height(), bottomRowFirst(rgba), spec.encoding());
        put(gl, 0, level);
        for (int number = 1; !level.isLast(); number++) {
            level = level.next();
            put(gl, number, level);
        }
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
    void requireUploaded() {
        if (!uploaded) {
            throw new IllegalStateException("image '" + label() + "' must be uploaded before a draw uses it");
        }
    }
}
