package sunbeam.app.scene;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import jrtr.RenderContext;
import sunbeam.app.files.output.SrgbImage;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.DisplayPass;
import sunbeam.app.gpu.picture.LinearPicture;

/** From a scene's linear picture to what one sees. Render and viewer both use it, so that they agree. */
public final class SceneDisplay implements AutoCloseable {
    // Pixels that the display shader gets at a time: 16 MB of texture.
    private static final int STRIP_PIXELS = 1 << 20;

    private final DisplayPass pass;

    /** Compiles the display shader. */
    public SceneDisplay(RenderContext context) {
        this.pass = new DisplayPass(context);
    }

    /** The scene's exposure, or where it has none, the one at which the whole picture is well lit. */
    public static double exposure(Scene scene, ScenePicture whole) {
        return scene.exposure().orElseGet(() -> AutoExposure.of(whole.linear()));
    }

    /** The picture before its background, which is not exposed; opaque sRGB. */
    public BufferedImage image(ScenePicture picture, double exposure, SceneColor background) {
        int width = picture.width();
        BufferedImage image = new BufferedImage(width, picture.height(), BufferedImage.TYPE_INT_RGB);
        int strips = 1 + (picture.height() - 1) / Math.max(1, STRIP_PIXELS / width);
        // All as large as the others, if only by a row less: the display pass keeps its textures for them.
        int rows = (picture.height() + strips - 1) / strips;
        for (int first = 0; first < picture.height(); first += rows) {
            int count = Math.min(rows, picture.height() - first);
            float[] srgb = pass.srgb(strip(picture, first, count, exposure, background), exposure);
            Raster strip = SrgbImage.fromEncoded(width, count, srgb).getRaster();
            image.getRaster().setDataElements(0, first, strip);
        }
        return image;
    }

    /** Rows of the picture laid over the background, which is divided by the exposure that will be applied. */
    private static LinearPicture strip(
            ScenePicture picture, int first, int count, double exposure, SceneColor background) {
        int width = picture.width();
        double[] behind = background.xyz();
        float[] xyz = new float[3 * width * count];
        for (int i = 0; i < width * count; i++) {
            int from = 4 * (first * width + i);
            double uncovered = Math.max(0, 1 - picture.rgba()[from + 3]);
            for (int c = 0; c < 3; c++) {
                xyz[3 * i + c] = (float) (picture.rgba()[from + c] + uncovered * behind[c] / exposure);
            }
        }
        return new LinearPicture(width, count, xyz);
    }

    @Override
    public void close() {
        pass.close();
    }
}
