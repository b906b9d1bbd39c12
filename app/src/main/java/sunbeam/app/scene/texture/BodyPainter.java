package sunbeam.app.scene.texture;

import java.util.stream.IntStream;

/** Paints a body's colors on a texture whose u runs along the body and whose v runs around it, from belly to belly. */
final class BodyPainter {
    private final int length;
    private final int girth;

    BodyPainter(int length, int girth) {
        this.length = length;
        this.girth = girth;
    }

    BodyTexture paint(BodyColors colors) {
        byte[] rgba = new byte[4 * length * girth];
        IntStream.range(0, girth).parallel().forEach(row -> {
            double around = 1 - 2 * (row + 0.5) / girth;
            for (int column = 0; column < length; column++) {
                LinearRgb color = colors.at((column + 0.5) / length, around);
                int texel = 4 * (row * length + column);
                rgba[texel] = LinearRgb.encoded(color.red());
                rgba[texel + 1] = LinearRgb.encoded(color.green());
                rgba[texel + 2] = LinearRgb.encoded(color.blue());
                rgba[texel + 3] = -1;
            }
        });
        return new BodyTexture(length, girth, rgba);
    }
}
