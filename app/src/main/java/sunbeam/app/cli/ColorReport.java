package sunbeam.app.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Result of the command for one surface.
 *
 * @param verdict verdict on the colors that the heights allow; its sentence says why there are none
 * @param colored whether the surface has a color of its own, outside its gloss
 * @param coherenceLength coherence length of the light, meters, as far as the scan's size allows it
 * @param colors colors by ascending viewing angle, those of strip along first, then those across
 * @param spectrum spectrum of the purest color, or without one in the mirror direction
 */
record ColorReport(
        Patch patch,
        GratingPeriod period,
        Verdict verdict,
        boolean colored,
        double coherenceLength,
        String plan,
        List<ViewColor> colors,
        Spectrum spectrum,
        Optional<ViewColor> purest) {
    // Luminance relative to the largest; a darker color has no hue.
    private static final double BLACK = 1e-9;

    /**
     * Relative radiance at {@link #nanometers}, and the band that makes the color, meters: half of the light lies within it, a quarter
     * below and a quarter above. Unlike a width at half maximum, it hardly changes with a single bright grain of speckle.
     */
    record Spectrum(ViewColor.View view, double[] radiances, double from, double to) {
        private static final int STEPS = 400;
        // Evaluations per nanometer: light as coherent as sunlight has orders 4 nm wide.
        private static final int PER_NANOMETER = 4;

        static double[] nanometers() {
            return IntStream.rangeClosed(CieTable.FIRST_NANOMETER, CieTable.FIRST_NANOMETER + STEPS)
                    .asDoubleStream()
                    .toArray();
        }

        static double[] fineWavelengths() {
            return IntStream.rangeClosed(0, STEPS * PER_NANOMETER)
                    .mapToDouble(i -> (CieTable.FIRST_NANOMETER + i / (double) PER_NANOMETER) * 1e-9)
                    .toArray();
        }

        /** @param fine radiances at {@link #fineWavelengths} */
        static Spectrum of(ViewColor.View view, double[] fine) {
            double[] wavelengths = fineWavelengths();
            double[] below = new double[fine.length];
            for (int i = 1; i < below.length; i++) {
                below[i] = below[i - 1] + 0.5 * (fine[i - 1] + fine[i]);
            }
            double[] radiances = new double[STEPS + 1];
            Arrays.setAll(radiances, nanometer -> fine[nanometer * PER_NANOMETER]);
            return new Spectrum(
                    view, radiances, quantile(wavelengths, below, 0.25), quantile(wavelengths, below, 0.75));
        }

        void putBand(Map<String, Object> fields) {
            fields.put("width_m", to - from);
            fields.put("quarter_m", from);
            fields.put("three_quarters_m", to);
        }

        Map<String, Object> fields() {
            Map<String, Object> values = new LinkedHashMap<>();
            values.put("strip", view.strip());
            values.put("theta_i_deg", view.thetaIDegrees());
            values.put("theta_r_deg", view.thetaRDegrees());
            putBand(values);
            values.put(
                    "wavelength_m",
                    Arrays.stream(nanometers()).map(length -> length / 1e9).toArray());
            values.put("relative_radiance", radiances);
            return values;
        }

        private static double quantile(double[] wavelengths, double[] below, double share) {
            double wanted = share * below[below.length - 1];
            int before = 0;
            while (before < below.length - 2 && below[before + 1] < wanted) {
                before++;
            }
            double step = below[before + 1] - below[before];
            double part = step > 0 ? (wanted - below[before]) / step : 0;
            return wavelengths[before] + part * (wavelengths[before + 1] - wavelengths[before]);
        }
    }

    List<String> lines() {
        List<String> lines = new ArrayList<>(List.of(verdict.sentence()));
        purest.ifPresent(color -> lines.add(Text.format(
                "purest color at %s degrees%s in the plane of azimuth %s (%s): %s, %s",
                Decimals.format(Math.rint(1000 * color.view().thetaRDegrees()) / 1000 + 0.0),
                isOfSecondOrder(color) ? " (second order)" : "",
                Text.wholeDegrees(color.view().phiDegrees()),
                color.view().strip(),
                color.describeHue(),
                color.hex())));
        double reach = CoherenceWindow.ofCoherenceLength(coherenceLength).mirrorReach(CieTable.MAXIMUM_WAVELENGTH, 0);
        if (colored
                && colors.stream().noneMatch(color -> color.view().distances().getMin() < reach)) {
            lines.add("the mirror direction lies beside both planes, and most colors with it; without --phi-i the light"
                    + " stands in each plane");
        }
        return lines;
    }

    private boolean isOfSecondOrder(ViewColor color) {
        double meters = color.view().distances().getAverage() * period.period();
        return period.others().isEmpty()
                && Math.round(1e9 * meters / color.hue().nanometers()) == 2;
    }

    Map<String, Object> fields() {
        Map<String, Object> fields = JsonOption.fields(patch, period, verdict);
        fields.put("theta_i_deg", colors.get(0).view().thetaIDegrees());
        fields.put("has_color", colored);
        fields.put("plane_azimuth_deg", colors.get(0).view().phiDegrees());
        fields.put("coherence_length_m", coherenceLength);
        fields.put("plan", plan);
        fields.put("model", patch.slopes().describe());
        Optional<Map<String, Object>> values = purest.map(ViewColor::fields);
        values.ifPresent(spectrum::putBand);
        fields.put("purest", values.orElse(null));
        fields.put("colors", colors.stream().map(ViewColor::fields).toList());
        fields.put("spectrum", spectrum.fields());
        return fields;
    }

    /** Returns a row for each color; undefined values are empty. Angles have no unit in their names, dominant wavelengths are in nm. */
    static StreamContent csv(List<ColorReport> reports) {
        List<Map<String, Object>> rows = new ArrayList<>();
        for (ColorReport report : reports) {
            ViewColor brightest = Collections.max(report.colors, Comparator.comparingDouble(color -> color.xyz()[1]));
            for (ViewColor color : report.colors) {
                Map<String, Object> cells = new LinkedHashMap<>(Map.of("patch", report.patch.name()));
                boolean hueless = color.xyz()[1] < BLACK * brightest.xyz()[1];
                color.fields().forEach((name, value) -> {
                    if (name.equals("dominant_m")) {
                        cells.put("dominant_nm", cell(value == null || hueless ? null : 1e9 * (Double) value));
                    } else {
                        String column = name.replaceFirst("^(phi|phi_i|theta_i|theta_r)_deg$", "$1");
                        cells.put(column, cell(name.equals("purity") && hueless ? null : value));
                    }
                });
                rows.add(cells);
            }
        }
        return StreamContent.of(CsvWriter.text(rows));
    }

    private static String cell(Object value) {
        return value == null ? "" : value instanceof Double number ? Text.format("%.7g", number) : value.toString();
    }

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
         * @param pairs directions whose weighted mean is the color, over the step of viewing angles, such as a pupil's aperture
         */
        record View(
                boolean along,
                double phiDegrees,
                double thetaIDegrees,
                double phiIDegrees,
                double thetaRDegrees,
                List<DirectionPair> pairs) {
            /** Returns |(u, v)| of the directions, which is 0 in the mirror direction. */
            DoubleSummaryStatistics distances() {
                return pairs.stream()
                        .mapToDouble(pair -> Math.hypot(pair.u(), pair.v()))
                        .summaryStatistics();
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
            double[] luminances = colors.stream()
                    .mapToDouble(color -> color.xyz()[1])
                    .sorted()
                    .toArray();
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
            values.replaceAll(
                    (key, value) -> value instanceof Double number && !Double.isFinite(number) ? null : value);
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
}
