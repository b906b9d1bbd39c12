package sunbeam.app.cli.color;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.text.Text;

/**
 * Color of a surface from one viewing direction.
 *
 * @param xyz X, Y, Z of the relative radiance, before exposure; chromaticity and hue are theirs
 * @param rgb screen color 0xRRGGBB, after exposure
 * @param lab CIE L*a*b* after exposure; a color brighter than white is first scaled to the luminance of white
 * @param uncertainty error of the computation in CIEDE2000, which 95 % of directions keep
 */
record ViewColor(
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
     * Viewing direction and light of a color; angles in degrees.
     *
     * @param along true in the plane across the lines of the grating, where color spreads most; false in the plane at right angles to it
     * @param thetaRDegrees angle of the viewer to the normal, positive towards the plane's azimuth
     * @param pairs directions whose mean is the color, evenly spread over the step of viewing angles, such as a pupil's aperture
     */
    record View(
            boolean along,
            double phiDegrees,
            double thetaIDegrees,
            double phiIDegrees,
            double thetaRDegrees,
            List<DirectionPair> pairs) {
        /** Returns the least |(u, v)| of the directions, which is 0 in the mirror direction. */
        double nearest() {
            return distances().min().orElseThrow();
        }

        double farthest() {
            return distances().max().orElseThrow();
        }

        private DoubleStream distances() {
            return pairs.stream().mapToDouble(pair -> Math.hypot(pair.u(), pair.v()));
        }

        String strip() {
            return along ? "along" : "across";
        }
    }

    static ViewColor of(View view, double[] xyz, DisplayTransform display, double tolerance, CieTable cie) {
        double exposure = display.exposure();
        double[] exposed = {exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]};
        Chromaticity chromaticity = Chromaticity.of(xyz);
        Chromaticity.Hue hue = chromaticity.hue(cie);
        double uncertainty = uncertainty(exposed, 3 * tolerance);
        return new ViewColor(view, xyz, display.rgb(xyz), chromaticity, hue, lab(exposed), uncertainty);
    }

    /**
     * Returns the color, of those in eligible views, of largest purity times the cube root of luminance, relative to a bright one of all: a
     * dark color does not win.
     */
    static Optional<ViewColor> purest(List<ViewColor> colors, Predicate<View> eligible) {
        double[] luminances =
                colors.stream().mapToDouble(color -> color.xyz()[1]).sorted().toArray();
        double bright = luminances.length == 0 ? 1 : luminances[(int) (BRIGHT * (luminances.length - 1))];
        return colors.stream()
                .filter(color -> eligible.test(color.view()))
                .max(Comparator.comparingDouble(
                        color -> color.hue().purity() * Math.cbrt(Math.min(1, color.xyz()[1] / bright))));
    }

    /** Returns the largest CIEDE2000 that relative errors of X, Y and Z by {@code share} cause, over all combinations of signs. */
    private static double uncertainty(double[] xyz, double share) {
        CieLab middle = lab(xyz);
        double largest = 0;
        for (int corner = 0; corner < 8; corner++) {
            double[] wrong = new double[3];
            for (int c = 0; c < 3; c++) {
                wrong[c] = xyz[c] * (1 + ((corner >> c & 1) == 0 ? -share : share));
            }
            largest = Math.max(largest, middle.difference(lab(wrong)));
        }
        return largest;
    }

    private static CieLab lab(double[] xyz) {
        double cut = 1 / Math.max(1, xyz[1]);
        return CieLab.ofXyz(cut * xyz[0], cut * xyz[1], cut * xyz[2]);
    }

    /** Returns all values; null for those that are not defined. */
    Map<String, Object> fields() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", view.strip());
        values.put("phi_deg", view.phiDegrees());
        values.put("theta_i_deg", view.thetaIDegrees());
        values.put("phi_i_deg", view.phiIDegrees());
        values.put("theta_r_deg", view.thetaRDegrees());
        values.put("srgb", hex());
        values.put("X", xyz[0]);
        values.put("Y", xyz[1]);
        values.put("Z", xyz[2]);
        values.put("x", chromaticity.x());
        values.put("y", chromaticity.y());
        values.put("dominant_m", 1e-9 * hue.nanometers());
        values.put("purity", hue.purity());
        values.put("lightness", lab.lightness());
        values.put("chroma", lab.chroma());
        values.put("hue_deg", Math.toDegrees(Math.atan2(lab.b(), lab.a())));
        values.put("delta_e", uncertainty);
        values.replaceAll((key, value) -> value instanceof Double number && !Double.isFinite(number) ? null : value);
        return values;
    }

    String hex() {
        return Text.format("#%06x", rgb);
    }

    String describeHue() {
        double wavelength = hue.nanometers();
        if (Double.isNaN(wavelength)) {
            return "no hue";
        }
        String kind = wavelength > 0 ? "dominant wavelength" : "purple, complement of";
        return Text.format("%s %.0f nm, purity %.2f", kind, Math.abs(wavelength), hue.purity());
    }
}
