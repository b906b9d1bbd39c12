package sunbeam.app.commands.color;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import sunbeam.precompute.color.DisplayColor;

/** The numbers: as rows of a CSV, and as a tree for JSON. */
final class ColorTables {
    private static final List<String> HEADER = List.of(
            "patch",
            "strip",
            "theta_i",
            "theta_r",
            "srgb",
            "X",
            "Y",
            "Z",
            "x",
            "y",
            "dominant_nm",
            "purity",
            "lightness",
            "chroma",
            "hue_deg",
            "delta_e",
            "blur_nm",
            "clipped",
            "near_mirror");

    private static final int SURE_DIGITS = 12;

    private ColorTables() {}

    /** A header and a row for each colour; what is no number is empty. */
    static String csv(List<ColorReport> reports) {
        StringBuilder text = new StringBuilder(String.join(",", HEADER)).append('\n');
        for (ColorReport report : reports) {
            for (SeenColor colour : report.colours()) {
                List<String> cells = new ArrayList<>(List.of(
                        '"' + report.name().replace("\"", "\"\"") + '"',
                        colour.view().along() ? "along" : "across",
                        number(colour.view().thetaIDegrees()),
                        number(colour.view().thetaRDegrees()),
                        colour.shown().hex()));
                numbers(colour).values().forEach(value -> cells.add(number(value)));
                cells.add(clipped(colour).orElse(""));
                cells.add(colour.nearMirror() ? "yes" : "no");
                text.append(String.join(",", cells)).append('\n');
            }
        }
        return text.toString();
    }

    private static Map<String, Double> numbers(SeenColor colour) {
        Map<String, Double> numbers = new LinkedHashMap<>();
        numbers.put("X", colour.xyz()[0]);
        numbers.put("Y", colour.xyz()[1]);
        numbers.put("Z", colour.xyz()[2]);
        numbers.put("x", colour.chromaticity().x());
        numbers.put("y", colour.chromaticity().y());
        numbers.put("dominant_nm", colour.hue().nanometres());
        numbers.put("purity", colour.hue().purity());
        numbers.put("lightness", colour.lab().lightness());
        numbers.put("chroma", colour.lab().chroma());
        numbers.put("hue_deg", colour.hueAngleDegrees());
        numbers.put("delta_e", colour.uncertainty().colour());
        numbers.put("blur_nm", colour.blurNanometres());
        return numbers;
    }

    /** What the hex colour leaves out. */
    private static Optional<String> clipped(SeenColor colour) {
        String lost = Stream.of(
                        colour.shown().tooBright() ? "brightness" : "",
                        colour.shown().tooPure() ? "saturation" : "")
                .filter(word -> !word.isEmpty())
                .collect(Collectors.joining(" and "));
        return lost.isEmpty() ? Optional.empty() : Optional.of(lost);
    }

    private static String number(double value) {
        return Double.isFinite(value) ? String.format(Locale.ROOT, "%.7g", value) : "";
    }

    /** What JSON writers make an object of. */
    static Map<String, Object> tree(List<ColorReport> reports, Map<String, Object> settings) {
        Map<String, Object> tree = new LinkedHashMap<>(settings);
        tree.put("surfaces", reports.stream().map(ColorTables::surface).toList());
        return tree;
    }

    private static Map<String, Object> surface(ColorReport report) {
        Map<String, Object> surface = new LinkedHashMap<>();
        surface.put("patch", report.name());
        surface.put("source", report.source());
        OptionalDouble halfWidth = report.direction().halfWidthDegrees();
        surface.put("direction_of_most_colour_deg", report.direction().azimuthDegrees());
        surface.put("direction_half_width_deg", halfWidth.isPresent() ? halfWidth.getAsDouble() : null);
        surface.put("light_azimuth_deg", report.lightAzimuthDegrees());
        surface.put("coherence_length_um", rounded(report.coherenceLength() * 1e6));
        surface.put("plan", report.plan());
        surface.put("model", report.model());
        surface.put("mirror_reach", report.reach().radius());
        surface.put("purest", report.purest().map(ColorTables::purest).orElse(null));
        surface.put(
                "colours", report.colours().stream().map(ColorTables::colour).toList());
        surface.put(
                "spectra", report.spectra().stream().map(ColorTables::spectrum).toList());
        return surface;
    }

    private static Map<String, Object> colour(SeenColor colour) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", colour.view().along() ? "along" : "across");
        values.put("theta_i", colour.view().thetaIDegrees());
        values.put("theta_r", colour.view().thetaRDegrees());
        values.put("srgb", colour.shown().hex());
        // JSON knows no NaN and no infinity.
        numbers(colour).forEach((key, value) -> values.put(key, Double.isFinite(value) ? value : null));
        values.put("clipped", clipped(colour).orElse(null));
        values.put("near_mirror", colour.nearMirror());
        return values;
    }

    private static Map<String, Object> purest(ColorReport.Purest purest) {
        Map<String, Object> values = colour(purest.colour());
        values.put(
                "srgb_brightest",
                DisplayColor.Hued.brightest(purest.colour().xyz()).hex());
        values.put("chroma_computation", purest.colour().uncertainty().chroma());
        values.put("window_nm", rounded(1e9 * purest.windowWidth()));
        putWidth(values, purest.width());
        return values;
    }

    private static void putWidth(Map<String, Object> values, SpectralWidth width) {
        values.put("fwhm_nm", rounded(1e9 * width.width()));
        values.put("fwhm_is_whole", width.whole());
        values.put("quarter_nm", rounded(1e9 * width.from()));
        values.put("three_quarters_nm", rounded(1e9 * width.to()));
        values.put("peak_nm", rounded(1e9 * width.peak()));
    }

    /** Conversion between units spoils the last digits. */
    private static double rounded(double value) {
        return new BigDecimal(value).round(new MathContext(SURE_DIGITS)).doubleValue();
    }

    private static Map<String, Object> spectrum(ColorReport.SeenSpectrum spectrum) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("theta_i", spectrum.view().thetaIDegrees());
        values.put("theta_r", spectrum.view().thetaRDegrees());
        putWidth(values, spectrum.width());
        double[] nanometres = spectrum.wavelengths().clone();
        for (int i = 0; i < nanometres.length; i++) {
            nanometres[i] = Math.round(nanometres[i] * 1e12) / 1e3;
        }
        values.put("wavelength_nm", nanometres);
        values.put("relative_radiance", spectrum.radiances());
        return values;
    }
}
