package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.reference.ExactLight;

/**
 * Compares random pixels of a BRDF map with the exact reference. Pairs of directions are by a pixel's number, row by row from the top left;
 * the material's reflectance is relative to that of the standard material.
 */
public record Certifier(
        ExactLight reference,
        IntFunction<DirectionPair> pairs,
        ToDoubleFunction<DirectionPair> material,
        ProgressDisplay display) {
    // At most one of this number of pixels is dark: light may be missing there, but a grating is nearly all dark.
    private static final int PIXELS_PER_DARK = 4;

    private double gain(DirectionPair pair) {
        return Gain.relativeRadiance(pair) * material.applyAsDouble(pair);
    }

    /**
     * Evaluates {@code count} random pixels, at most all, in parallel; at most a quarter of them are dark, unless there are too few bright
     * ones, and all show the surface.
     *
     * @param picture linear XYZ of rho
     * @param exposure factor for X, Y, Z before colors are compared
     * @param tolerance relative error for which the picture was made
     */
    public Certificate certify(LinearPicture picture, int count, double exposure, double tolerance) {
        List<Comparison> all = display.map("Certificate", draw(picture, count), pixel -> compare(picture, pixel));
        return Certificate.ofPixels(
                all.size() + " random pixels, at most a quarter of them dark while there are others",
                all,
                exposure,
                Certificate.Limits.of(tolerance));
    }

    private List<Integer> draw(LinearPicture picture, int count) {
        List<Integer> bright = new ArrayList<>();
        List<Integer> dark = new ArrayList<>();
        for (int pixel = 0; pixel < picture.width() * picture.height(); pixel++) {
            if (picture.covered(pixel)) {
                double floor = Comparison.FLOOR * gain(pairs.apply(pixel));
                // The largest decides: a NaN or an infinite value makes a pixel bright, so that it is checked.
                (Comparison.largest(Comparison.xyz(picture.xyz(), pixel)) <= floor ? dark : bright).add(pixel);
            }
        }
        Random random = new Random(Certificate.SEED);
        Collections.shuffle(bright, random);
        Collections.shuffle(dark, random);
        int reservedDark = Math.min(dark.size(), count / PIXELS_PER_DARK);
        int brightCount = Math.min(bright.size(), count - reservedDark);
        List<Integer> pixels = new ArrayList<>(bright.subList(0, brightCount));
        pixels.addAll(dark.subList(0, Math.min(dark.size(), count - brightCount)));
        return pixels;
    }

    private Comparison compare(LinearPicture picture, int pixel) {
        DirectionPair pair = pairs.apply(pixel);
        double gain = gain(pair);
        double[] exact = reference.xyz(pair, ExactLight.Quadrature.INTEGRATED);
        for (int c = 0; c < 3; c++) {
            exact[c] *= gain;
        }
        return new Comparison(Comparison.xyz(picture.xyz(), pixel), exact, gain);
    }
}
