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
import sunbeam.precompute.reference.ReferenceColor.Quadrature;

/**
 * Compares random pixels of a BRDF map with the exact reference.
 *
 * @param reference of the same patch and window as the map
 * @param pairs the directions at a pixel's centre, counted row by row from the top left
 * @param display shows progress
 * @param material what it reflects over what the standard material does
 */
public record Certifier(
        ExactLight reference,
        IntFunction<DirectionPair> pairs,
        ToDoubleFunction<DirectionPair> material,
        ProgressDisplay display) {
    // Dark pixels are checked too, lest light be missing; but a picture of a grating is nearly all dark.
    private static final int LARGEST_DARK_SHARE = 4;

    private double gain(DirectionPair pair) {
        return Gain.relativeRadiance(pair) * material.applyAsDouble(pair);
    }

    /**
     * Evaluates random pixels in parallel, with progress.
     *
     * @param picture linear XYZ of rho; pixels that show no surface are not drawn from
     * @param count how many pixels; all, when the picture has fewer. At most a quarter are such as the picture shows
     *     dark, unless there are not enough others.
     * @param exposure factor for X, Y, Z before colors are compared
     * @param tolerance what the picture was made for
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
                // A NaN or an infinity among X and Z is to be looked at.
                (Comparison.largest(Comparison.xyz(picture.xyz(), pixel)) <= floor ? dark : bright).add(pixel);
            }
        }
        Random random = new Random(Certificate.SEED);
        Collections.shuffle(bright, random);
        Collections.shuffle(dark, random);
        int fewestDark = Math.min(dark.size(), count / LARGEST_DARK_SHARE);
        int takenBright = Math.min(bright.size(), count - fewestDark);
        List<Integer> pixels = new ArrayList<>(bright.subList(0, takenBright));
        pixels.addAll(dark.subList(0, Math.min(dark.size(), count - takenBright)));
        return pixels;
    }

    private Comparison compare(LinearPicture picture, int pixel) {
        DirectionPair pair = pairs.apply(pixel);
        double gain = gain(pair);
        double[] exact = reference.xyz(pair, Quadrature.INTEGRATED);
        for (int c = 0; c < 3; c++) {
            exact[c] *= gain;
        }
        return new Comparison(Comparison.xyz(picture.xyz(), pixel), exact, gain);
    }
}
