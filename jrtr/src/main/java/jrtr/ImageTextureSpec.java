package jrtr;

/**
 * Shape of an 8-bit RGBA texture.
 *
 * @param width texels per row, at least 1
 * @param height rows, at least 1
 */
public record ImageTextureSpec(int width, int height, ColorEncoding encoding, Wrap wrap) {

    public ImageTextureSpec {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException(
                    "image of " + width + " x " + height + ": both sides must be at least 1");
        }
    }

    /** Returns the bytes of the image without mipmaps: 4 x width x height. */
    public long bytes() {
        return 4L * width * height;
    }
}
