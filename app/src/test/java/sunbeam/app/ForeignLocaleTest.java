package sunbeam.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.Environment;

/**
 * Where digits are Arabic, commands write the same names and the same bytes as elsewhere: outputs, tables in the cache,
 * what is printed, and so what the shaders were told. Without {@link Main}, which sets the locale.
 */
@NeedsDisplay
final class ForeignLocaleTest {
    private static final Locale ARABIC_DIGITS = Locale.forLanguageTag("ar-SA-u-nu-arab");
    private static final String PRINTED = "printed";

    private final Locale all = Locale.getDefault();
    private final Locale format = Locale.getDefault(Locale.Category.FORMAT);
    private final Locale display = Locale.getDefault(Locale.Category.DISPLAY);

    @TempDir
    private Path folder;

    @AfterEach
    void restore() {
        Locale.setDefault(all);
        Locale.setDefault(Locale.Category.FORMAT, format);
        Locale.setDefault(Locale.Category.DISPLAY, display);
    }

    @Test
    void whatIsWrittenDoesNotKnowTheCountry() throws IOException {
        Map<String, String> there = written(ARABIC_DIGITS, folder.resolve("there"));
        Map<String, String> plain = written(Locale.ROOT, folder.resolve("plain"));

        assertThat(plain.keySet())
                .contains(PRINTED, "sheet.png", "bins.csv", "bins.json", "bins.npy", "map.png", "some.csv", "terms.h5")
                .contains("frames/frame-0001.png")
                .anyMatch(name -> name.startsWith(".cache/"));
        assertThat(there.keySet()).isEqualTo(plain.keySet());
        assertThat(there.get(PRINTED)).isEqualTo(plain.get(PRINTED));
        plain.forEach((name, content) ->
                assertThat(there.get(name).equals(content)).as(name).isTrue());
    }

    /** What lies in the folder afterwards, by name: bytes as Latin letters; and what was printed. */
    private static Map<String, String> written(Locale locale, Path folder) throws IOException {
        Files.createDirectories(folder);
        Path directions = folder.resolve("directions.csv");
        Files.writeString(directions, "theta_i,phi_i,theta_r,phi_r\n30,0,10.5,20\n75,0,5,180\n");
        StringWriter printed = new StringWriter();
        Locale.setDefault(locale);
        for (String command : List.of(
                "inspect sinusoid --json --output sheet.png",
                "evaluate --patch blaze --method bins --wavelengths 400:700:100 --output bins",
                "precompute --patch blaze --terms 7 --expansion taylor --output terms.h5",
                "brdf-map --patch blaze --size 16 --annotate --explain --output map.png",
                "reflectance --patch blaze --directions directions.csv --output some.csv",
                "render elaphe --mesh plane --patch blaze --texture none --size 16x16 --turntable 2 --output frames")) {
            Environment environment = new Environment(Map.of(), folder);
            PrintWriter writer = new PrintWriter(printed);
            String[] arguments = command.replaceAll("(?<=--output |--directions )", folder + "/")
                    .split(" ");
            assertThat(new Sunbeam(environment, writer, writer).run(arguments))
                    .as(printed.toString())
                    .isZero();
        }
        Map<String, String> result = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                result.put(folder.relativize(file).toString(), Files.readString(file, StandardCharsets.ISO_8859_1));
            }
        }
        // Times differ.
        result.put(PRINTED, printed.toString().replace(folder.toString(), "").replaceAll("in [0-9.]+ s", "in time"));
        return result;
    }
}
