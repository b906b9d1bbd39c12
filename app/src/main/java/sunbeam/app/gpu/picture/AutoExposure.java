package sunbeam.app.gpu.picture;

import java.util.Arrays;

/**
 * The exposure at which what a picture shows is well lit: the one definition for maps, pictures of scenes, the viewer and {@code color}
 * (docs/theory.md).
 *
 * <p>Pixels are sorted by luminance Y, and each counts by its lightness, the cube root of Y (CIE 1976), so that black counts nothing.
 * The geometric mean of Y over the brighter half, by lightness, is drawn at {@link #TARGET}. It is a mean over many pixels, not the value
 * at one rank: it follows small changes by as little.
 */
public final class AutoExposure {
    /** Display luminance of the brighter half's mean; white is 1. Orders several times brighter are compressed. */
    public static final double TARGET = 0.3;

    // Share of the picture's lightness in the darker half.
    private static final double DARKER = 0.5;

    private AutoExposure() {}

    /** Returns the factor of linear XYZ; 1 for a picture without light. Ignores NaN and values not above zero. */
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

    /** Returns the positive luminances in ascending order. */
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
