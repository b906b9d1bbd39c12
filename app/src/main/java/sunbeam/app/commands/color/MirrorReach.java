package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.List;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;

/**
 * Which directions see the mirror's light and its surroundings, the gloss, and no order (docs/color.md): those with |(u,
 * v)| up to five deviations of the coherence window's spectrum at 780 nm, where an order is 130 nm wide or more, and those
 * to which waves of the surface longer than 5 um send visible light: unevenness that makes gloss, for which the eye sees
 * no colour but that of a glare that falls faster for blue than for red.
 */
record MirrorReach(CoherenceWindow window) {
    /** Luminance, in proportion to a mirror's, below which no colour is promised, nor seen beside the mirror. */
    private static final double FAINTEST = 1e-9;

    /** |(u, v)| up to which the mirror reaches. */
    double radius() {
        return window.mirrorReach();
    }

    /** Whether a direction lies within. */
    boolean holds(DirectionPair pair) {
        return Math.hypot(pair.u(), pair.v()) <= radius();
    }

    /** Whether what a direction sees, linear X, Y, Z, may be a colour of the surface: outside, and no rounding error. */
    boolean leaves(DirectionPair pair, double[] xyz) {
        return !holds(pair) && xyz[1] >= FAINTEST;
    }

    /** Those of some colours that the mirror leaves, as a row of pixels. */
    LinearPicture outside(List<SeenColor.View> views, List<double[]> colours) {
        List<double[]> left = new ArrayList<>();
        for (int i = 0; i < views.size(); i++) {
            if (leaves(views.get(i).pair(), colours.get(i))) {
                left.add(colours.get(i));
            }
        }
        return picture(left);
    }

    /** Linear X, Y, Z as a row of pixels. */
    static LinearPicture picture(List<double[]> colours) {
        float[] xyz = new float[3 * colours.size()];
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = (float) colours.get(i / 3)[i % 3];
        }
        return new LinearPicture(colours.size(), 1, xyz);
    }

    /**
     * Full width at half maximum of the band of wavelengths that one order of an endless regular surface sends in a
     * direction, metres: what the window alone makes. Of the ensemble average and of one coherence area alike.
     *
     * @param wavelength in the band's middle, metres
     */
    double orderWidth(double wavelength, DirectionPair pair) {
        return 2
                * Math.sqrt(Math.log(2))
                * wavelength
                * wavelength
                * window.sigmaFrequency()
                / Math.hypot(pair.u(), pair.v());
    }
}
