package sunbeam.app.cli.color;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.text.Text;

/**
 * The color that one direction sees.
 *
 * @param view where from
 * @param xyz linear, of the relative radiance, before exposure
 * @param rgb 0xRRGGBB on a screen, after exposure
 * @param chromaticity of xyz
 * @param hue dominant wavelength and purity
 * @param lab after exposure; what is brighter than white is cut to white's luminance first
 * @param uncertainty CIEDE2000 that the computation may err by: 95 % of directions keep it
 */
record SeenColor(
        View view,
        double[] xyz,
        int rgb,
        Chromaticity chromaticity,
        Chromaticity.Hue hue,
        CieLab lab,
        double uncertainty) {
    // Quantile of the luminances; darker colors weigh less in the search for the purest.
    private static final double BRIGHT = 0.9;

    /**
     * Where it is seen from.
     *
     * @param along whether in the plane of the direction of most color, or across it
     * @param phiDegrees azimuth of that plane
     * @param thetaIDegrees of the light to the normal
     * @param phiIDegrees azimuth of the light
     * @param thetaRDegrees of the viewer to the normal, positive towards the plane's azimuth
     * @param pairs directions whose mean is seen, evenly spread over the angles that a pupil takes in
     */
    record View(
            boolean along,
            double phiDegrees,
            double thetaIDegrees,
            double phiIDegrees,
            double thetaRDegrees,
            List<DirectionPair> pairs) {
        /** The least |(u, v)| of the directions. */
        double nearest() {
            return pairs.stream()
                    .mapToDouble(pair -> Math.hypot(pair.u(), pair.v()))
                    .min()
                    .orElseThrow();
        }

        String strip() {
            return along ? "along" : "across";
        }
    }

    /** How colors become numbers. */
    record Scale(DisplayTransform display, double tolerance, CieTable cie) {}

    static SeenColor of(View view, double[] xyz, Scale scale) {
        double exposure = scale.display().exposure();
        double[] exposed = {exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]};
        Chromaticity chromaticity = Chromaticity.of(xyz);
        return new SeenColor(
                view,
                xyz,
                scale.display().rgb(xyz),
                chromaticity,
                chromaticity.hue(scale.cie()),
                lab(exposed),
                uncertainty(exposed, 3 * scale.tolerance()));
    }

    /**
     * The one with the largest product of excitation purity and lightness, the cube root of luminance: what is dark beside the
     * others does not win. No exposure changes it.
     */
    static Optional<SeenColor> purest(List<SeenColor> colors) {
        double[] luminances =
                colors.stream().mapToDouble(color -> color.xyz()[1]).sorted().toArray();
        double bright = luminances.length == 0 ? 1 : luminances[(int) (BRIGHT * (luminances.length - 1))];
        return colors.stream()
                .max(Comparator.comparingDouble(
                        color -> color.hue().purity() * Math.cbrt(Math.min(1, color.xyz()[1] / bright))));
    }

    /** The largest difference that errors of X, Y and Z by a share make, in any combination of signs. */
    private static double uncertainty(double[] xyz, double share) {
        CieLab middle = lab(xyz);
        double largest = 0;
        for (int corner = 0; corner < 8; corner++) {
            double[] wrong = new double[3];
            for (int c = 0; c < 3; c++) {
                wrong[c] = xyz[c] * (1 + ((corner >> c & 1) == 0 ? -share : share));
            }
            largest = Math.max(largest, ColorDifference.ciede2000(middle, lab(wrong)));
        }
        return largest;
    }

    private static CieLab lab(double[] xyz) {
        double cut = 1 / Math.max(1, xyz[1]);
        return CieLab.ofXyz(cut * xyz[0], cut * xyz[1], cut * xyz[2]);
    }

    /** Color as in a style sheet, {@code #1a2b3c}. */
    String hex() {
        return Text.format("#%06x", rgb);
    }

    double hueAngleDegrees() {
        return Math.toDegrees(Math.atan2(lab.b(), lab.a()));
    }

    String describeHue() {
        double wavelength = hue.nanometres();
        if (Double.isNaN(wavelength)) {
            return "no hue";
        }
        return Text.format(
                wavelength > 0
                        ? "dominant wavelength %.0f nm, purity %.2f"
                        : "purple, complement of %.0f nm, purity %.2f",
                Math.abs(wavelength),
                hue.purity());
    }
}
