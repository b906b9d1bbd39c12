package sunbeam.app.scene.texture;

/**
 * A picture for a mesh, sRGB. Its left edge is texture coordinate u = 0, its bottom v = 0; it repeats beyond its edges.
 *
 * @param width texels per row
 * @param height rows
 * @param rgba {@code 4 * width * height} bytes, red first, row 0 on top. Shared, not copied
 */
public record BodyTexture(int width, int height, byte[] rgba) {

    /** Rejects arrays of another length. */
    public BodyTexture {
        if (width < 1 || height < 1 || rgba.length != 4L * width * height) {
            throw new IllegalArgumentException(
                    rgba.length + " bytes do not make a texture of " + width + " x " + height + " x 4");
        }
    }
}
