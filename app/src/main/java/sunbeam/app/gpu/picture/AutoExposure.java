package sunbeam.app.gpu.picture;

import java.util.Arrays;

/**
 * The exposure at which what a picture shows is well lit: the one definition for maps, pictures of scenes and the viewer
 * (docs/exposure.md).
 *
 * <p>Pixels are sorted by luminance Y, and each counts by its lightness, the cube root of Y (CIE 1976), so that black
 * counts nothing. Of those between 75 % and 95 % of the lightness in all, the geometric mean of Y is drawn at 0.85 of
 * white. A mean over a band, not the value at one rank: where few pixels lie between a dark ground and bright orders, one
 * rank would jump from the one to the other. The brightest 5 % of the lightness, glints and specular peaks, have no say in
 * it, however bright.
 */
public final class AutoExposure {
    /** What the chosen luminance is drawn at; white is 1. */
    public static final double TARGET = 0.85;

    // Shares of the picture's lightness below the band and up to its end.
    private static final double BAND_START = 0.75;
    private static final double BAND_END = 0.95;

    private AutoExposure() {}

    /** Factor for linear XYZ; 1 for a picture without light. What is no number or not above zero does not count. */
    public static double of(LinearPicture... pictures) {
        double[] luminances = luminances(pictures);
        double all = 0;
        for (double luminance : luminances) {
            all += Math.cbrt(luminance);
        }
        if (!(all > 0)) {
            return 1;
        }
        double below = 0;
        double logarithms = 0;
        double weights = 0;
        for (double luminance : luminances) {
            double upTo = below + Math.cbrt(luminance) / all;
            double weight = Math.min(upTo, BAND_END) - Math.max(below, BAND_START);
            if (weight > 0) {
                logarithms += weight * Math.log(luminance);
                weights += weight;
            }
            below = upTo;
        }
        return TARGET / Math.exp(logarithms / weights);
    }

    /** Those that count, in ascending order. */
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
