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
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;

/** The picture and, beside it, the numbers as CSV and JSON. */
final class ColorFiles {
    private final FileGroup files;
    private final String pictureEnding;

    /** @param picture whose ending, if it has one, is the picture's; the others' take its place */
    ColorFiles(Path picture, Overwrite overwrite) {
        String name = picture.getFileName().toString();
        int dot = name.lastIndexOf('.');
        pictureEnding = dot > 0 ? name.substring(dot) : "";
        Path stem = dot > 0 ? picture.resolveSibling(name.substring(0, dot)) : picture;
        files = new FileGroup(stem, List.of(pictureEnding, ".csv", ".json"), overwrite);
    }

    /** Before anything is computed. */
    void checkWritable() {
        files.checkWritable();
    }

    /**
     * All files or none.
     *
     * @param warnings what was said of the surfaces and their colours, for JSON
     * @return where they are
     */
    List<Path> write(List<ColorReport> reports, Map<String, Object> settings, List<String> warnings, ColorSheet sheet) {
        Map<String, String> text = new LinkedHashMap<>();
        text.put(
                "Title", "Colours of " + reports.stream().map(ColorReport::name).collect(Collectors.joining(", ")));
        text.put("Patch", reports.stream().map(ColorReport::source).collect(Collectors.joining("; ")));
        settings.forEach((key, value) ->
                text.put(key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1), value.toString()));
        ObjectMapper json = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
        Map<String, AtomicFile.StreamContent> contents = new LinkedHashMap<>();
        contents.put(pictureEnding, stream -> PngWriter.write(stream, sheet.draw(), text));
        contents.put(".csv", stream -> stream.write(ColorTables.csv(reports).getBytes(StandardCharsets.UTF_8)));
        Map<String, Object> tree = ColorTables.tree(reports, settings);
        tree.put("warnings", warnings);
        contents.put(".json", stream -> stream.write(json.writeValueAsBytes(tree)));
        return files.write(contents);
    }
}
