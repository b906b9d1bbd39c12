package sunbeam.app.commands.color;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;

/** The picture and, beside it, the numbers as CSV and JSON. */
record ColorFiles(Path picture, Overwrite overwrite) {
    List<Path> all() {
        return List.of(picture, sibling("csv"), sibling("json"));
    }

    private Path sibling(String ending) {
        String name = picture.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return picture.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + "." + ending);
    }

    /** Before anything is computed. */
    void checkWritable() {
        all().forEach(file -> AtomicFile.checkWritable(file, overwrite));
    }

    /** All files or none: none appears before all are written. */
    void write(List<ColorReport> reports, Map<String, Object> settings, ColorSheet sheet) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put(
                "Title", "Colours of " + reports.stream().map(ColorReport::name).collect(Collectors.joining(", ")));
        text.put("Patch", reports.stream().map(ColorReport::source).collect(Collectors.joining("; ")));
        settings.forEach((key, value) ->
                text.put(key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1), value.toString()));
        ObjectMapper json = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
        List<Path> files = all();
        try (AtomicFile image = AtomicFile.create(files.get(0), overwrite);
                AtomicFile csv = AtomicFile.create(files.get(1), overwrite);
                AtomicFile tree = AtomicFile.create(files.get(2), overwrite)) {
            image.fill(stream -> PngWriter.write(stream, sheet.draw(), text));
            csv.fill(stream -> stream.write(ColorTables.csv(reports).getBytes(StandardCharsets.UTF_8)));
            tree.fill(stream -> stream.write(json.writeValueAsBytes(ColorTables.tree(reports, settings))));
            image.commit();
            csv.commit();
            tree.commit();
        }
    }
}
