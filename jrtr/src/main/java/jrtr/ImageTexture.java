package jrtr;

/**
 * A picture for shaders: 8-bit RGBA, {@code sampler2D}, trilinear between mipmaps that are averaged in linear light. The
 * picture's bottom left corner is at texture coordinate (0, 0), its top right at (1, 1), as mesh files have it.
 */
public interface ImageTexture extends Texture, Resource {

    /**
     * Uploads the picture and makes its mipmaps.
     *
     * @param rgba 4 x width x height bytes, red first, row 0 the picture's top
     * @throws IllegalArgumentException if there are more or fewer
     */
    void upload(byte[] rgba);
}
