package sunbeam.app.commands.color;

import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.color.DisplayColor;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;

/**
 * The colour that one direction sees.
 *
 * @param view where from
 * @param xyz linear, of the relative radiance, before exposure
 * @param rgb 0xRRGGBB after exposure
 * @param chromaticity of xyz
 * @param hue dominant wavelength and purity
 * @param lab after exposure; what is brighter than white is cut to white's luminance first
 * @param uncertainty largest CIEDE2000 that errors of X, Y and Z by three tolerances each make: 95 % of directions keep it
 * @param blurNanometres width at half height of the band of wavelengths that one order sends here, at 550 nm, by the finite
 *     coherence length; infinite in the mirror direction
 */
record SeenColor(
        View view,
        double[] xyz,
        int rgb,
        Chromaticity chromaticity,
        Chromaticity.Hue hue,
        CieLab lab,
        double uncertainty,
        double blurNanometres) {

    private static final double WAVELENGTH = 550e-9;

    /**
     * Where it is seen from.
     *
     * @param along whether in the plane of the strongest direction, or across it
     * @param thetaIDegrees of the light to the normal
     * @param thetaRDegrees of the viewer to the normal, negative on the other side
     */
    record View(boolean along, double thetaIDegrees, double thetaRDegrees, DirectionPair pair) {}

    static SeenColor of(
            View view, double[] xyz, double exposure, double tolerance, CoherenceWindow window, CieTable cie) {
        double[] exposed = {exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]};
        Chromaticity chromaticity = Chromaticity.of(xyz);
        double uv = Math.hypot(view.pair().u(), view.pair().v());
        // FWHM of a Gaussian; the ensemble's is narrower by sqrt(2) than that of amplitudes.
        double blur = 2
                * Math.sqrt(2 * Math.log(2))
                * WAVELENGTH
                * WAVELENGTH
                * window.sigmaFrequency()
                / (Math.sqrt(2) * uv);
        return new SeenColor(
                view,
                xyz,
                DisplayColor.rgb(exposed),
                chromaticity,
                chromaticity.hue(cie),
                lab(exposed),
                uncertainty(exposed, 3 * tolerance),
                1e9 * blur);
    }

    private static CieLab lab(double[] xyz) {
        double cut = 1 / Math.max(1, xyz[1]);
        return CieLab.ofXyz(cut * xyz[0], cut * xyz[1], cut * xyz[2]);
    }

    private static double uncertainty(double[] xyz, double relative) {
        CieLab middle = lab(xyz);
        double largest = 0;
        for (int corner = 0; corner < 8; corner++) {
            double[] wrong = new double[3];
            for (int c = 0; c < 3; c++) {
                wrong[c] = xyz[c] * (1 + ((corner >> c & 1) == 0 ? -relative : relative));
            }
            largest = Math.max(largest, ColorDifference.ciede2000(middle, lab(wrong)));
        }
        return largest;
    }

    /** Degrees from red to yellow, CIE 1976. */
    double hueAngleDegrees() {
        return Math.toDegrees(Math.atan2(lab.b(), lab.a()));
    }
}
