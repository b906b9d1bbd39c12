package sunbeam.app.commands.color;

import java.util.function.ToDoubleFunction;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.color.DisplayColor;
import sunbeam.precompute.optics.DirectionPair;

/**
 * The colour that one direction sees.
 *
 * @param view where from
 * @param xyz linear, of the relative radiance, before exposure
 * @param shown on a screen, after exposure
 * @param chromaticity of xyz
 * @param hue dominant wavelength and purity
 * @param lab after exposure; what is brighter than white is cut to white's luminance first
 * @param uncertainty what the computation may change: 95 % of directions keep it
 * @param nearMirror whether the direction lies within the mirror's reach
 * @param blurNanometres width at half maximum of the band of wavelengths that the coherence window alone makes of one order
 *     here, at 550 nm; NaN where that is wider than the visible band: there is no order
 */
record SeenColor(
        View view,
        double[] xyz,
        DisplayColor.Hued shown,
        Chromaticity chromaticity,
        Chromaticity.Hue hue,
        CieLab lab,
        Uncertainty uncertainty,
        boolean nearMirror,
        double blurNanometres) {

    static final double WAVELENGTH = 550e-9;
    private static final double VISIBLE_BAND_NANOMETRES = 400;

    /**
     * Where it is seen from.
     *
     * @param along whether in the plane of the direction of most colour, or across it
     * @param thetaIDegrees of the light to the normal
     * @param thetaRDegrees of the viewer to the normal, negative on the other side
     */
    record View(boolean along, double thetaIDegrees, double thetaRDegrees, DirectionPair pair) {}

    /**
     * The largest differences that errors of X, Y and Z by three tolerances each make, in any combination of signs.
     *
     * @param colour CIEDE2000
     * @param chroma of C*
     */
    record Uncertainty(double colour, double chroma) {
        private static Uncertainty of(double[] xyz, double relative) {
            CieLab middle = lab(xyz);
            return new Uncertainty(
                    largest(xyz, relative, wrong -> ColorDifference.ciede2000(middle, wrong)),
                    largest(xyz, relative, wrong -> Math.abs(wrong.chroma() - middle.chroma())));
        }

        private static double largest(double[] xyz, double relative, ToDoubleFunction<CieLab> difference) {
            double largest = 0;
            for (int corner = 0; corner < 8; corner++) {
                double[] wrong = new double[3];
                for (int c = 0; c < 3; c++) {
                    wrong[c] = xyz[c] * (1 + ((corner >> c & 1) == 0 ? -relative : relative));
                }
                largest = Math.max(largest, difference.applyAsDouble(lab(wrong)));
            }
            return largest;
        }
    }

    static SeenColor of(View view, double[] xyz, double exposure, double tolerance, MirrorReach reach, CieTable cie) {
        double[] exposed = {exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]};
        Chromaticity chromaticity = Chromaticity.of(xyz);
        double blur = 1e9 * reach.orderWidth(WAVELENGTH, view.pair());
        return new SeenColor(
                view,
                xyz,
                DisplayColor.Hued.of(exposed),
                chromaticity,
                chromaticity.hue(cie),
                lab(exposed),
                Uncertainty.of(exposed, 3 * tolerance),
                reach.holds(view.pair()),
                blur <= VISIBLE_BAND_NANOMETRES ? blur : Double.NaN);
    }

    private static CieLab lab(double[] xyz) {
        double cut = 1 / Math.max(1, xyz[1]);
        return CieLab.ofXyz(cut * xyz[0], cut * xyz[1], cut * xyz[2]);
    }

    /** Degrees from red to yellow, CIE 1976. */
    double hueAngleDegrees() {
        return Math.toDegrees(Math.atan2(lab.b(), lab.a()));
    }
}
