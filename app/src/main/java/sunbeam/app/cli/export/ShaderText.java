package sunbeam.app.cli.export;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Fills in resource files (shaders, pages, notes): a table's numbers replace {@code @NAMES@}. */
final class ShaderText {
    // Schlick's reflectance along the normal, for refractive index 1.5.
    private static final double REFLECTANCE = 0.04;

    private ShaderText() {}

    static String read(String name) {
        try (InputStream stream = ShaderText.class.getResourceAsStream(name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException failure) {
            throw new UncheckedIOException(name, failure);
        }
    }

    static String about(String name, TableMetadata metadata) {
        return fill(read(name), words(metadata));
    }

    static String page(String name, TableMetadata metadata) {
        float exposure = (float) HtmlTable.exposure(metadata.grid(), HtmlTable.THETA);
        return fill(read(name), Map.of("EXPOSURE", String.valueOf(exposure)));
    }

    private static Map<String, String> words(TableMetadata metadata) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("PATCH", plain(metadata.setup().patch().name()));
        values.put("LENGTH", Lengths.rounded(metadata.coherenceLength(), 3));
        values.put("VERSION", Version.number());
        values.put("ERROR", metadata.error());
        values.put("LAYERS", String.valueOf(metadata.grid().shape().depth().count()));
        return values;
    }

    static String function(String name, TableMetadata metadata, int doublings) {
        GridShape shape = metadata.grid().shape();
        Map<String, String> values = words(metadata);
        values.put("U", number(shape.u().first()));
        values.put("V", number(shape.v().first()));
        values.put("STEP", number(shape.u().step()));
        values.put("COLUMNS", number(shape.u().count()));
        values.put("ROWS", number(shape.v().count()));
        values.put("DEPTH", number(shape.depth().first()));
        values.put("DEPTH_STEP", number(shape.depth().step()));
        values.put("SLICES", number(shape.depth().count()));
        ColorTable.Level level = metadata.grid().level();
        double sigma = GridShape.sigma(level.area().window(), ColorTable.MIDDLE_WAVELENGTH);
        values.put("SIGMA", number(sigma));
        values.put("BRDF", number(REFLECTANCE / (2 * Math.PI * sigma * sigma * level.scale())));
        values.put("COARSEST", number(doublings));
        return fill(read(name), values);
    }

    static String fill(String text, Map<String, String> values) {
        String filled = text;
        for (Map.Entry<String, String> value : values.entrySet()) {
            filled = filled.replace("@" + value.getKey() + "@", value.getValue());
        }
        return filled;
    }

    /** Replaces all characters but letters, digits and plain punctuation by "_": a file's name may hold any. */
    static String plain(String name) {
        return name.replaceAll("[^\\p{L}\\p{N} .,_+-]", "_");
    }

    private static String number(double value) {
        return Text.format("%.9e", value);
    }
}
