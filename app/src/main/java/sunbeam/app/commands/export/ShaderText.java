package sunbeam.app.commands.export;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.units.Lengths;

/** Texts that come with Sunbeam, with a table's numbers in the place of {@code @NAMES@}. */
final class ShaderText {
    private ShaderText() {}

    /** The text of a resource. */
    static String read(String name) {
        try (InputStream stream = ShaderText.class.getResourceAsStream(name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException failure) {
            throw new UncheckedIOException(name, failure);
        }
    }

    /** The function of light and view. */
    static String function(TableText text, int doublings) {
        GridShape shape = text.grid().shape();
        Map<String, String> values = new LinkedHashMap<>();
        values.put("PATCH", plain(text.setup().patch().name()));
        values.put("LENGTH", Lengths.rounded(text.coherenceLength(), 3));
        values.put("VERSION", Version.number());
        values.put("U", number(shape.u().first()));
        values.put("V", number(shape.v().first()));
        values.put("STEP", number(shape.u().step()));
        values.put("COLUMNS", number(shape.u().count()));
        values.put("ROWS", number(shape.v().count()));
        values.put("DEPTH", number(shape.depth().first()));
        values.put("DEPTH_STEP", number(shape.depth().step()));
        values.put("SLICES", number(shape.depth().count()));
        values.put("SIGMA", number(GridShape.sigma(text.grid().level().area().window(), ColorTable.MIDDLE_WAVELENGTH)));
        values.put("COARSEST", number(doublings));
        return filled(read("sunbeam.glsl"), values);
    }

    static String filled(String text, Map<String, String> values) {
        String filled = text;
        for (Map.Entry<String, String> value : values.entrySet()) {
            filled = filled.replace("@" + value.getKey() + "@", value.getValue());
        }
        return filled;
    }

    /** A name of a file may hold anything. */
    static String plain(String name) {
        return name.replaceAll("[^\\p{L}\\p{N} ._+-]", "_");
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.9e", value);
    }
}
