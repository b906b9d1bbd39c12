package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;

class ImageTextureTest extends InARendering {
    private ImageTexture image(int width, int height, ImageTexture.Encoding encoding, int... rgba) {
        byte[] bytes = new byte[rgba.length];
        for (int index = 0; index < rgba.length; index++) {
            bytes[index] = (byte) rgba[index];
        }
        return rendering.context.createImageTexture("image", width, height, bytes, encoding);
    }

    @Test
    void theTopRowOfThePictureIsAtTheTopTextureCoordinates() {
        ImageTexture texture = image(1, 2, ImageTexture.Encoding.LINEAR, 255, 0, 0, 255, 0, 255, 0, 255);
        ShaderProgram program = rendering.program("uniform sampler2D t;", "textureLod(t, vec2(0.5, 0.75), 0.0)");

        assertThat(rendering.drawn(program, 1, 1, Map.of("t", texture))).containsExactly(1, 0, 0, 1);
    }

    @Test
    void sRgbBytesGiveLinearLight() {
        ImageTexture srgb = image(1, 1, ImageTexture.Encoding.SRGB, 188, 10, 255, 128);
        ImageTexture linear = image(1, 1, ImageTexture.Encoding.LINEAR, 188, 10, 255, 128);
        ShaderProgram program = rendering.program("uniform sampler2D t;", "texture(t, vec2(0.5))");

        float[] decoded = rendering.drawn(program, 1, 1, Map.of("t", srgb));
        float[] plain = rendering.drawn(program, 1, 1, Map.of("t", linear));

        assertThat(decoded[0]).isCloseTo((float) light(188), within(halfAStep(188)));
        assertThat(decoded[1]).isCloseTo((float) light(10), within(halfAStep(10)));
        assertThat(decoded[2]).isEqualTo(1);
        assertThat(decoded[3]).isCloseTo(128 / 255f, within(1e-6f));
        assertThat(plain[0]).isCloseTo(188 / 255f, within(1e-6f));
    }

    /** Area means: three columns become one, and a row between two pairs counts half for each. */
    @Test
    void mipmapsAreMeansInLinearLight() {
        ImageTexture.MipLevel wide =
                new ImageTexture.MipLevel(3, 2, rgba(0, 255, 30, 255, 90, 0), ImageTexture.Encoding.LINEAR).next();
        ImageTexture.MipLevel high =
                new ImageTexture.MipLevel(1, 5, rgba(0, 100, 200, 50, 150), ImageTexture.Encoding.LINEAR).next();
        ImageTexture.MipLevel light = new ImageTexture.MipLevel(2, 1, rgba(0, 255), ImageTexture.Encoding.SRGB).next();

        assertThat(wide.width()).isEqualTo(1);
        assertThat(wide.height()).isEqualTo(1);
        assertThat(wide.rgba()[0] & 0xFF).isEqualTo(630 / 6);
        assertThat(high.height()).isEqualTo(2);
        assertThat(high.rgba()[0] & 0xFF).isEqualTo((int) ((0 + 100 + 0.5 * 200) / 2.5));
        assertThat(high.rgba()[4] & 0xFF).isEqualTo((int) ((0.5 * 200 + 50 + 150) / 2.5));
        assertThat(light(light.rgba()[0] & 0xFF)).isCloseTo(0.5, within((double) halfAStep(188)));
        assertThat(light.rgba()[3] & 0xFF).isEqualTo(128);
    }

    /** Gray texels, as opaque as they are bright. */
    private static byte[] rgba(int... values) {
        byte[] bytes = new byte[4 * values.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) values[i / 4];
        }
        return bytes;
    }

    /** IEC 61966-2-1. */
    private static double light(double code) {
        double value = code / 255;
        return value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    }

    /** OpenGL sets no precision for decoding; llvmpipe's polynomial is off by 1.5e-3. Half a code cannot be seen. */
    private static float halfAStep(int code) {
        return (float) (light(code + 0.5) - light(code - 0.5)) / 2;
    }
}
