package sunbeam.app.gpu.picture;

import java.util.Arrays;

/**
 * The exposure at which the diffracted light is well lit. The specular peak outshines the rest by up to 1e5, so neither
 * the maximum nor the mean will do.
 */
public final class AutoExposure {
    // What this share of the lit pixels stays below is drawn just below white.
    private static final double SHARE = 0.97;
    private static final double WHITE = 0.85;
    // Pixels darker than this share of the brightest are background: a lone order on black must not be drawn as white.
    private static final double LIT = 1e-3;

    private AutoExposure() {}

    /** Whether a pixel, counted row by row, belongs to the specular peak and is left out. */
    @FunctionalInterface
    public interface Specular {
        boolean contains(int pixel);
    }

    /** Factor for linear XYZ; 1 for a picture without light. */
    public static double of(LinearPicture picture, Specular specular) {
        double[] luminances = new double[picture.width() * picture.height()];
        int count = 0;
        for (int i = 0; i < luminances.length; i++) {
            if (picture.covered(i) && !specular.contains(i) && Float.isFinite(picture.luminance(i))) {
                luminances[count++] = picture.luminance(i);
            }
        }
        Arrays.sort(luminances, 0, count);
        if (count == 0 || luminances[count - 1] <= 0) {
            return 1;
        }
        double threshold = LIT * luminances[count - 1];
        int first = 0;
        while (luminances[first] < threshold) {
            first++;
        }
        int chosen = first + (int) (SHARE * (count - 1 - first));
        return WHITE / luminances[chosen];
    }
}
