package sunbeam.app.scene.texture;

/**
 * A picture for a mesh, sRGB. Its left edge is texture coordinate u = 0, its bottom v = 0; it repeats beyond its edges.
 *
 * @param rgba {@code 4 * width * height} bytes, red first, row 0 on top. Shared, not copied
 */
public record BodyTexture(int width, int height, byte[] rgba) {}
