package sunbeam.app.gpu.picture;

import java.util.List;
import jrtr.Binding;
import jrtr.FloatFormat;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.Tile;
import sunbeam.app.gpu.KeptTarget;
import sunbeam.app.gpu.Shaders;

/**
 * Turns linear XYZ into sRGB with the shader that the window uses too (shaders/include/display.glsl). Keeps room on the
 * graphics card for pictures of the last size.
 */
public final class DisplayPass implements AutoCloseable {
    private final RenderContext context;
    private final ShaderProgram program;
    private final KeptTarget displays;
    private FloatTexture kept;

    /** Compiles the shader. */
    public DisplayPass(RenderContext context) {
        this.context = context;
        this.program = context.createFullScreenProgram(Shaders.library().load("display.frag"));
        this.displays = new KeptTarget(context, "display", FloatTargetSpec.Format.RGBA32F);
    }

    /**
     * Applies exposure, gamut and sRGB curve.
     *
     * @return {@code height * width * 3} values in [0, 1], row 0 on top; NaN where there is no surface
     */
    public float[] srgb(LinearPicture picture, double exposure) {
        int width = picture.width();
        int height = picture.height();
        float[] texels = new float[4 * width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int pixel = row * width + column;
                // Textures count rows from the bottom as fragments do.
                int texel = 4 * ((height - 1 - row) * width + column);
                if (picture.covered(pixel)) {
                    System.arraycopy(picture.xyz(), 3 * pixel, texels, texel, 3);
                    texels[texel + 3] = 1;
                }
            }
        }
        FloatTarget display = displays.of(width, height);
        FloatTexture linear = linear(width, height);
        linear.upload(texels);
        program.set("exposure", (float) exposure);
        context.drawFullScreen(
                program, List.of(new Binding("linearPicture", linear)), display, Tile.whole(width, height));
        return colors(display.read(0));
    }

    private FloatTexture linear(int width, int height) {
        FloatTextureSpec spec = FloatTextureSpec.flat(width, height, FloatFormat.RGBA32F);
        if (kept == null || !kept.spec().equals(spec)) {
            release();
            kept = context.createFloatTexture("picture", spec);
        }
        return kept;
    }

    private void release() {
        if (kept != null) {
            kept.close();
            kept = null;
        }
    }

    private static float[] colors(float[] rgba) {
        float[] colors = new float[rgba.length / 4 * 3];
        for (int i = 0; i < rgba.length / 4; i++) {
            boolean covered = rgba[4 * i + 3] > 0;
            for (int c = 0; c < 3; c++) {
                colors[3 * i + c] = covered ? rgba[4 * i + c] : Float.NaN;
            }
        }
        return colors;
    }

    @Override
    public void close() {
        release();
        displays.close();
        program.close();
    }
}
