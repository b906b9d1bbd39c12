package jrtr;

/**
 * Images that draws write to: RGBA32F, unclamped, no blending, no sRGB; or, where screens show them, RGBA8. Contents are undefined until cleared or drawn.
 *
 * <p>What is read back has row 0 at the TOP; {@code gl_FragCoord} counts rows from the bottom, so the fragment at {@code
 * gl_FragCoord.xy = (x + 0.5, y + 0.5)} is read back in row {@code height - 1 - y}.
 */
public interface FloatTarget extends Resource {

    /** The shape asked for. */
    FloatTargetSpec spec();

    /**
     * Sets the tile's pixels of every image, and their depth, where there is one, to 1 (the far plane).
     *
     * @throws IllegalArgumentException if the tile is not inside
     */
    void clear(Tile tile, float red, float green, float blue, float alpha);

    /**
     * Reads a whole image: {@code 4 * width * height} floats, RGBA interleaved, row 0 on top.
     *
     * @param color which image, from 0
     * @throws GraphicsException if the image has more floats than a Java array; read it tile by tile then
     */
    float[] read(int color);

    /**
     * Reads part of an image: {@code 4 * tile.width * tile.height} floats, RGBA interleaved, the tile's top row first.
     *
     * @throws IllegalArgumentException if the tile is not inside
     */
    float[] read(int color, Tile tile);

    /**
     * Reads part of an image as screens show it: 0xAARRGGBB a pixel, each value clamped to [0, 1] and rounded to 8 bits, the
     * tile's top row first.
     *
     * @throws IllegalArgumentException if the tile is not inside
     */
    int[] readColors(int color, Tile tile);

    /**
     * An image as a texture (nearest, clamped) for a later draw into another target. Here {@code gl_FragCoord}'s row
     * order holds: texel row 0 is the bottom.
     *
     * @param color which image, from 0
     */
    Texture texture(int color);
}
