package sunbeam.app.cli.color;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import sunbeam.app.cli.options.JsonOption;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.text.Text;

/** Writes the picture, and the numbers as CSV and JSON in files of the same name. */
final class ColorFiles {
    private final FileGroup files;
    private final String pictureEnding;

    /** @param picture file of the picture; .csv and .json replace its ending in the other files' names */
    ColorFiles(Path picture, Overwrite overwrite) {
        String stem = FileNames.stem(picture);
        pictureEnding = picture.getFileName().toString().substring(stem.length());
        files = new FileGroup(picture.resolveSibling(stem), List.of(pictureEnding, ".csv", ".json"), overwrite);
    }

    void checkWritable() {
        files.checkWritable();
    }

    /** Writes all files or none, and returns their paths. */
    List<Path> write(List<ColorReport> reports, Map<String, Object> settings, List<String> warnings, ColorSheet sheet) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put(
                "Title", "Colors of " + joined(reports, report -> report.patch().name()));
        text.put("Patch", joined(reports, report -> report.patch().source()));
        settings.forEach((key, value) ->
                text.put(key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1), value.toString()));
        Map<String, Object> tree = new LinkedHashMap<>(settings);
        tree.put("surfaces", reports.stream().map(ColorFiles::surface).toList());
        tree.put("warnings", warnings);
        Map<String, AtomicFile.StreamContent> contents = new LinkedHashMap<>();
        contents.put(pictureEnding, stream -> PngWriter.write(stream, sheet.draw(), text));
        contents.put(".csv", AtomicFile.StreamContent.of(csv(reports)));
        contents.put(".json", AtomicFile.StreamContent.of(JsonOption.text(tree)));
        return files.write(contents);
    }

    private static String joined(List<ColorReport> reports, Function<ColorReport, String> what) {
        return reports.stream().map(what).collect(Collectors.joining("; "));
    }

    /** Returns a header and a row for each color; a cell is empty if its value is NaN. */
    private static String csv(List<ColorReport> reports) {
        List<Map<String, Object>> rows = new ArrayList<>();
        for (ColorReport report : reports) {
            for (SeenColor color : report.colors()) {
                Map<String, Object> cells = new LinkedHashMap<>();
                cells.put("patch", report.patch().name());
                color(color).forEach((name, value) -> cells.put(name, cell(value)));
                rows.add(cells);
            }
        }
        return CsvWriter.text(rows);
    }

    private static String cell(Object value) {
        return value == null ? "" : value instanceof Double number ? Text.format("%.7g", number) : value.toString();
    }

    /** Returns the values by column; null in place of NaN, which JSON does not have. */
    private static Map<String, Object> color(SeenColor color) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", color.view().strip());
        values.put("phi", color.view().phiDegrees());
        values.put("theta_i", color.view().thetaIDegrees());
        values.put("phi_i", color.view().phiIDegrees());
        values.put("theta_r", color.view().thetaRDegrees());
        values.put("srgb", color.hex());
        values.put("X", color.xyz()[0]);
        values.put("Y", color.xyz()[1]);
        values.put("Z", color.xyz()[2]);
        values.put("x", color.chromaticity().x());
        values.put("y", color.chromaticity().y());
        values.put("dominant_nm", color.hue().nanometers());
        values.put("purity", color.hue().purity());
        values.put("lightness", color.lab().lightness());
        values.put("chroma", color.lab().chroma());
        values.put("hue_deg", color.hueAngleDegrees());
        values.put("delta_e", color.uncertainty());
        values.replaceAll((key, value) -> value instanceof Double number && !Double.isFinite(number) ? null : value);
        return values;
    }

    private static Map<String, Object> surface(ColorReport report) {
        Map<String, Object> surface = new LinkedHashMap<>();
        surface.put("patch", report.patch().name());
        surface.put("source", report.patch().source());
        surface.put("verdict", report.verdict());
        surface.put("verdict_code", report.code());
        surface.put("has_color", report.colored());
        surface.put("plane_azimuth_deg", report.azimuthDegrees());
        surface.put("grating", report.period().isSure() ? grating(report.period()) : null);
        surface.put(
                "about_nm",
                report.period().isSeen() ? nanometers(report.period().period()) : null);
        surface.put("directions_deg", report.period().isSeen() ? report.period().directions() : List.of());
        surface.put("coherence_length_um", rounded(report.coherenceLength() * 1e6, 4));
        surface.put("plan", report.plan());
        surface.put("model", ModelError.of(report.patch().scan()).describe());
        surface.put(
                "purest",
                report.purest()
                        .map(color -> {
                            Map<String, Object> values = color(color);
                            values.putAll(band(report.spectrum()));
                            return values;
                        })
                        .orElse(null));
        surface.put("colors", report.colors().stream().map(ColorFiles::color).toList());
        surface.put("spectrum", spectrum(report.spectrum()));
        return surface;
    }

    private static Map<String, Object> grating(GratingPeriod period) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("period_nm", nanometers(period.period()));
        values.put("period_low_nm", nanometers(period.low()));
        values.put("period_high_nm", nanometers(period.high()));
        values.put("azimuth_across_lines_deg", Math.toDegrees(period.azimuth()));
        return values;
    }

    private static Map<String, Object> band(SeenSpectrum spectrum) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("width_nm", nanometers(spectrum.width()));
        values.put("quarter_nm", nanometers(spectrum.from()));
        values.put("three_quarters_nm", nanometers(spectrum.to()));
        return values;
    }

    private static Map<String, Object> spectrum(SeenSpectrum spectrum) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", spectrum.view().strip());
        values.put("theta_i", spectrum.view().thetaIDegrees());
        values.put("theta_r", spectrum.view().thetaRDegrees());
        values.putAll(band(spectrum));
        values.put("wavelength_nm", spectrum.nanometers());
        values.put("relative_radiance", spectrum.radiances());
        return values;
    }

    private static double nanometers(double meters) {
        return rounded(meters * 1e9, 3);
    }

    /** Rounds to a number of decimals, as the conversion between units changes the last digits. */
    private static double rounded(double value, int decimals) {
        double scale = Math.pow(10, decimals);
        return Math.rint(value * scale) / scale;
    }
}
