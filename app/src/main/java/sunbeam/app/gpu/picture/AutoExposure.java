package sunbeam.app.gpu.picture;

import java.util.Arrays;

/**
 * Automatic exposure by a picture's brighter pixels, the same for maps, pictures of scenes, the viewer and {@code color} (docs/theory.md).
 *
 * <p>Pixels are sorted by luminance Y, and each is weighted by its lightness, the cube root of Y (CIE 1976), so that black pixels have no
 * weight. The brightest pixels with half of the total weight are the brighter half; the exposure maps the geometric mean of their Y to
 * {@link #TARGET}. Unlike a percentile, a mean over many pixels changes little if the picture changes little.
 */
public final class AutoExposure {
    /** Display luminance to which the brighter half's mean is mapped; white is 1. Orders several times brighter are compressed. */
    public static final double TARGET = 0.42;

    private static final double DARKER = 0.5;

    private AutoExposure() {}

    /**
     * Returns the exposure for all pictures together, a factor of linear XYZ; 1 for pictures without light. Ignores pixels whose Y is NaN,
     * infinite, zero or negative.
     */
    public static double of(LinearPicture... pictures) {
        double[] luminances = luminances(pictures);
        double[] roots = Arrays.stream(luminances).map(Math::cbrt).toArray();
        double all = Arrays.stream(roots).sum();
        if (!(all > 0)) {
            return 1;
        }
        double below = 0;
        double logarithms = 0;
        double weights = 0;
        for (int i = 0; i < roots.length; i++) {
            double upTo = below + roots[i] / all;
            double weight = upTo - Math.max(below, DARKER);
            if (weight > 0) {
                logarithms += weight * Math.log(luminances[i]);
                weights += weight;
            }
            below = upTo;
        }
        return TARGET / Math.exp(logarithms / weights);
    }

    private static double[] luminances(LinearPicture... pictures) {
        int pixels = Arrays.stream(pictures)
                .mapToInt(picture -> picture.width() * picture.height())
                .reduce(0, Math::addExact);
        double[] luminances = new double[pixels];
        int count = 0;
        for (LinearPicture picture : pictures) {
            for (int i = 0; i < picture.width() * picture.height(); i++) {
                float luminance = picture.luminance(i);
                if (luminance > 0 && Float.isFinite(luminance)) {
                    luminances[count++] = luminance;
                }
            }
        }
        double[] sorted = Arrays.copyOf(luminances, count);
        Arrays.sort(sorted);
        return sorted;
    }
}
