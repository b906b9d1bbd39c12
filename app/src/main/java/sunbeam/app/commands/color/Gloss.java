package sunbeam.app.commands.color;

import java.util.ArrayList;
import java.util.List;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.optics.CoherenceWindow;

/**
 * The mirror's light and its surroundings ({@link CoherenceWindow#mirrorReach}): a thousand times brighter than any order, and
 * without a color of the surface.
 */
record Gloss(CoherenceWindow window) {
    /** Luminance, in proportion to a mirror's, below which no color is promised. */
    private static final double FAINTEST = 1e-9;

    /** Whether what a direction sees, linear X, Y, Z, may be a color of the surface. */
    boolean leaves(SeenColor.View view, double[] xyz) {
        return Math.hypot(view.pair().u(), view.pair().v()) > window.mirrorReach() && xyz[1] >= FAINTEST;
    }

    /** Those of some colors that may be the surface's, as a row of pixels; of all where there are none. */
    LinearPicture outside(List<SeenColor.View> views, List<double[]> colors) {
        List<double[]> left = new ArrayList<>();
        for (int i = 0; i < views.size(); i++) {
            if (leaves(views.get(i), colors.get(i))) {
                left.add(colors.get(i));
            }
        }
        return picture(left.isEmpty() ? colors : left);
    }

    /** Linear X, Y, Z as a row of pixels. */
    static LinearPicture picture(List<double[]> colors) {
        float[] xyz = new float[3 * colors.size()];
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = (float) colors.get(i / 3)[i % 3];
        }
        return new LinearPicture(colors.size(), 1, xyz);
    }
}
