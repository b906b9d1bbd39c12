package sunbeam.app.commands.color;

import java.util.List;
import java.util.OptionalInt;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieTable;

/**
 * Which of some directions has the purest colour that one sees (docs/color.md): that with the largest product of excitation
 * purity and lightness. Lightness is the cube root of the luminance in proportion to that of these directions which is
 * drawn at 0.85 of white, at most 1: what is dark beside the others does not win, and beyond that brightness says nothing.
 * Neither depends on the exposure that is drawn with.
 */
record PurestColor(MirrorReach reach, CieTable cie) {

    /**
     * The choice.
     *
     * @param colours linear X, Y, Z for each of the views
     * @return empty where the mirror's light is all there is
     */
    OptionalInt of(List<SeenColor.View> views, List<double[]> colours) {
        double exposure = AutoExposure.of(reach.outside(views, colours));
        OptionalInt best = OptionalInt.empty();
        double largest = -1;
        for (int i = 0; i < views.size(); i++) {
            double[] xyz = colours.get(i);
            if (!reach.leaves(views.get(i).pair(), xyz)) {
                continue;
            }
            double purity = Math.min(1, Chromaticity.of(xyz).hue(cie).purity());
            double seen = purity * Math.cbrt(Math.min(1, exposure / AutoExposure.TARGET * xyz[1]));
            if (seen > largest) {
                largest = seen;
                best = OptionalInt.of(i);
            }
        }
        return best;
    }
}
