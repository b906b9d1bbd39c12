package sunbeam.app.cli.color;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import sunbeam.app.cli.report.ReportFields;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.patch.ModelError;
import sunbeam.precompute.text.Text;

/** Writes the picture, and the numbers as CSV and JSON in files of the same name. */
final class ColorFiles {
    private final FileGroup files;
    private final String pictureEnding;

    ColorFiles(Path picture, Overwrite overwrite) {
        String stem = FileNames.stem(picture);
        pictureEnding = picture.getFileName().toString().substring(stem.length());
        files = new FileGroup(picture.resolveSibling(stem), List.of(pictureEnding, ".csv", ".json"), overwrite);
    }

    void checkWritable() {
        files.checkWritable();
    }

    static Map<String, Object> tree(
            List<ColorReport> reports, Map<String, Object> settings, List<String> warnings, ColorSheet sheet) {
        Map<String, Object> tree = new LinkedHashMap<>(settings);
        List<Map<String, Object>> surfaces =
                reports.stream().map(ColorFiles::surface).toList();
        surfaces.get(0).put("thumbnail_px", sheet.thumbnail());
        tree.put("surfaces", surfaces);
        tree.put("warnings", warnings);
        return tree;
    }

    List<Path> write(List<ColorReport> reports, Map<String, Object> settings, String json, ColorSheet sheet) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put(
                "Title", "Colors of " + joined(reports, report -> report.patch().name()));
        text.put("Patch", joined(reports, report -> report.patch().source()));
        settings.forEach((key, value) ->
                text.put(key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1), value.toString()));
        Map<String, AtomicFile.StreamContent> contents = new LinkedHashMap<>();
        contents.put(pictureEnding, stream -> PngWriter.write(stream, sheet.draw(), text));
        contents.put(".csv", AtomicFile.StreamContent.of(csv(reports)));
        contents.put(".json", AtomicFile.StreamContent.of(json));
        return files.write(contents);
    }

    private static String joined(List<ColorReport> reports, Function<ColorReport, String> what) {
        return reports.stream().map(what).collect(Collectors.joining("; "));
    }

    /**
     * Returns a header and a row for each color; a cell is empty if its value is NaN. Columns of angles have no unit in their names, the
     * dominant wavelength is in nm.
     */
    private static String csv(List<ColorReport> reports) {
        List<Map<String, Object>> rows = new ArrayList<>();
        for (ColorReport report : reports) {
            for (ViewColor color : report.colors()) {
                Map<String, Object> cells = new LinkedHashMap<>();
                cells.put("patch", report.patch().name());
                color(color).forEach((name, value) -> {
                    if (name.equals("dominant_m")) {
                        cells.put("dominant_nm", cell(value == null ? null : 1e9 * (Double) value));
                    } else {
                        cells.put(name.replaceFirst("^(phi|phi_i|theta_i|theta_r)_deg$", "$1"), cell(value));
                    }
                });
                rows.add(cells);
            }
        }
        return CsvWriter.text(rows);
    }

    private static String cell(Object value) {
        return value == null ? "" : value instanceof Double number ? Text.format("%.7g", number) : value.toString();
    }

    private static Map<String, Object> color(ViewColor color) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", color.view().strip());
        values.put("phi_deg", color.view().phiDegrees());
        values.put("theta_i_deg", color.view().thetaIDegrees());
        values.put("phi_i_deg", color.view().phiIDegrees());
        values.put("theta_r_deg", color.view().thetaRDegrees());
        values.put("srgb", color.hex());
        values.put("X", color.xyz()[0]);
        values.put("Y", color.xyz()[1]);
        values.put("Z", color.xyz()[2]);
        values.put("x", color.chromaticity().x());
        values.put("y", color.chromaticity().y());
        values.put("dominant_m", 1e-9 * color.hue().nanometers());
        values.put("purity", color.hue().purity());
        values.put("lightness", color.lab().lightness());
        values.put("chroma", color.lab().chroma());
        values.put("hue_deg", color.hueAngleDegrees());
        values.put("delta_e", color.uncertainty());
        values.replaceAll((key, value) -> value instanceof Double number && !Double.isFinite(number) ? null : value);
        return values;
    }

    private static Map<String, Object> surface(ColorReport report) {
        Map<String, Object> surface = ReportFields.of(report.patch(), report.period(), report.verdict());
        surface.put("theta_i_deg", report.colors().get(0).view().thetaIDegrees());
        surface.put("has_color", report.colored());
        surface.put("plane_azimuth_deg", report.azimuthDegrees());
        surface.put("coherence_length_m", report.coherenceLength());
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

    private static Map<String, Object> band(ViewSpectrum spectrum) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("width_m", spectrum.width());
        values.put("quarter_m", spectrum.from());
        values.put("three_quarters_m", spectrum.to());
        return values;
    }

    private static Map<String, Object> spectrum(ViewSpectrum spectrum) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", spectrum.view().strip());
        values.put("theta_i_deg", spectrum.view().thetaIDegrees());
        values.put("theta_r_deg", spectrum.view().thetaRDegrees());
        values.putAll(band(spectrum));
        values.put(
                "wavelength_m",
                Arrays.stream(spectrum.nanometers())
                        .map(nanometers -> nanometers / 1e9)
                        .toArray());
        values.put("relative_radiance", spectrum.radiances());
        return values;
    }
}
