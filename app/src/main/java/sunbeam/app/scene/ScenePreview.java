package sunbeam.app.scene;

/**
 * A picture with fewer pixels than asked for.
 *
 * @param picture what is shown
 * @param bodyIsFiner whether its pixels are those of the body, and diffraction has fewer
 * @param meshNanoseconds time that went to the mesh
 * @param diffractionNanoseconds time that went to the pixels of the diffracted light
 */
public record ScenePreview(
        ScenePicture picture, boolean bodyIsFiner, long meshNanoseconds, long diffractionNanoseconds) {

    /**
     * The part of a frame's time that a coarser preview would not save.
     *
     * @param nanoseconds that the frame took in all
     */
    public long fixed(long nanoseconds) {
        return bodyIsFiner ? nanoseconds - diffractionNanoseconds : meshNanoseconds;
    }

    /**
     * Diffracted light laid over a body that has more pixels, by the blend of shaders/include/blend.glsl.
     *
     * @param body without diffraction
     * @param light the same scene without body
     * @param intensity of the light
     * @param white luminance that is white on screen; what is brighter is cut there, or else a glint would fill the
     *     pixels between it and its neighbors
     */
    static ScenePicture composed(ScenePicture body, ScenePicture light, double intensity, double white) {
        ScenePicture diffracted = cut(light, white);
        ScenePicture whole = ScenePicture.empty(body.width(), body.height());
        float[] here = new float[4];
        for (int y = 0; y < body.height(); y++) {
            double row = (y + 0.5) * diffracted.height() / body.height() - 0.5;
            for (int x = 0; x < body.width(); x++) {
                int pixel = 4 * (y * body.width() + x);
                if (body.rgba()[pixel + 3] == 0) {
                    continue;
                }
                diffracted.sample((x + 0.5) * diffracted.width() / body.width() - 0.5, row, here);
                double alpha = intensity > 0 ? Math.min(1, here[1] / intensity) : 0;
                for (int c = 0; c < 3; c++) {
                    whole.rgba()[pixel + c] = (float) (here[c] + (1 - alpha) * body.rgba()[pixel + c]);
                }
                whole.rgba()[pixel + 3] = 1;
            }
        }
        return whole;
    }

    private static ScenePicture cut(ScenePicture picture, double white) {
        float[] rgba = picture.rgba().clone();
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            double factor = Math.min(1, white / rgba[pixel + 1]);
            for (int c = 0; c < 3; c++) {
                rgba[pixel + c] *= (float) factor;
            }
        }
        return new ScenePicture(picture.width(), picture.height(), rgba);
    }
}
