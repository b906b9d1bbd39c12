package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.text.Text;

/** {@link TestField} in every readable format, as documented. */
final class TestScans {
    private TestScans() {}

    static ChannelList channels(ScanBytes bytes) throws IOException {
        return ScanFormats.find(bytes, Optional.empty()).orElseThrow().open(bytes);
    }

    /** Content by name of the format. */
    static Map<String, byte[]> all() {
        Map<String, byte[]> all = new LinkedHashMap<>();
        all.put("gwy", gwyddion("m", "m"));
        all.put("gsf", simpleField("XYUnits = m\nZUnits = m\n"));
        all.put("gwyddion-text", gwyddionText(false, "\n"));
        all.put("gwyddion-text-german", gwyddionText(true, "\r\n"));
        all.put("spip-text", spipText());
        all.put("points", points());
        all.put("nanoscope", TestInstruments.nanoscope(2, 2));
        all.put("nanoscope-32", TestInstruments.nanoscope(4, 4));
        all.put("nanoscope-32-of-16", TestInstruments.nanoscope(4, 2));
        all.put("ibw", TestInstruments.igorWave());
        all.put("nid", TestInstruments.nanosurf());
        all.put("stp", TestInstruments.wsxm("double"));
        all.put("top", TestInstruments.wsxm("short"));
        all.put("jpk", TestInstruments.jpk(true));
        all.put("jpk-qi-image", TestInstruments.jpk(false));
        all.put("park", TestInstruments.park());
        all.put("sdf-text", TestInstruments.surfaceData(false));
        all.put("sdf-binary", TestInstruments.surfaceData(true));
        all.put("x3p", TestInstruments.x3p());
        all.put("sur", TestInstruments.digitalSurf());
        all.put("mi", TestInstruments.agilent());
        return all;
    }

    static byte[] gwyddion(String unitXy, String unitZ) {
        TestBytes data = TestBytes.little();
        item(data, "xres", 'i').int32(TestField.COLUMNS);
        item(data, "yres", 'i').int32(TestField.ROWS);
        item(data, "xreal", 'd').float64(TestField.WIDTH);
        item(data, "yreal", 'd').float64(TestField.HEIGHT);
        object(
                data,
                "si_unit_xy",
                "GwySIUnit",
                item(TestBytes.little(), "unitstr", 's').text(unitXy + "\0"));
        object(
                data,
                "si_unit_z",
                "GwySIUnit",
                item(TestBytes.little(), "unitstr", 's').text(unitZ + "\0"));
        item(data, "data", 'D').int32(TestField.COLUMNS * TestField.ROWS);
        TestField.downwards(nanometers -> data.float64(1e-9 * nanometers));
        TestBytes container = TestBytes.little();
        item(container, "/0/data/title", 's').text("Height\0");
        item(container, "/0/data/visible", 'b').int8(1);
        object(container, "/0/data", "GwyDataField", data);
        return TestBytes.little()
                .text("GWYPGwyContainer\0")
                .int32(container.size())
                .bytes(container.array())
                .array();
    }

    private static TestBytes item(TestBytes bytes, String name, char type) {
        return bytes.text(name + "\0").int8(type);
    }

    private static void object(TestBytes bytes, String name, String type, TestBytes content) {
        item(bytes, name, 'o').text(type + "\0").int32(content.size()).bytes(content.array());
    }

    static byte[] simpleField(String units) {
        String header = "Gwyddion Simple Field 1.0\nXRes = %d\nYRes = %d\nXReal = %s\nYReal = %s\nTitle = Height\n%s"
                .formatted(TestField.COLUMNS, TestField.ROWS, TestField.WIDTH, TestField.HEIGHT, units);
        TestBytes bytes = TestBytes.little().text(header);
        bytes.zeros(4 - bytes.size() % 4);
        TestField.downwards(nanometers -> bytes.float32(1e-9 * nanometers));
        return bytes.array();
    }

    /** As Gwyddion exports a matrix, in English or with the decimal commas and words of German. */
    static byte[] gwyddionText(boolean german, String lineEnd) {
        String header = german
                ? "# Kanal: H\u00f6he\n# Breite: 3,5 \u00b5m\n# H\u00f6he: 2,0 \u00b5m\n# Einheit der Werte: m\n"
                : "# Channel: Height\n# Width: 3.5 \u00b5m\n# Height: 2.0 \u00b5m\n# Value units: m\n";
        StringBuilder text = new StringBuilder(header);
        matrix(text, 1e-9, "%.3e");
        String written = (german ? text.toString().replace('.', ',') : text.toString()).replace("\n", lineEnd);
        return written.getBytes(StandardCharsets.UTF_8);
    }

    static byte[] spipText() {
        StringBuilder text =
                new StringBuilder("# File Format = ASCII\n# Created by SPIP 6.0\n# Original file: a.spm\n");
        text.append("# x-pixels = 7\n# y-pixels = 5\n# x-length = 3500\n# y-length = 2000\n# z-unit = nm\n");
        text.append("# Start of Data:\n");
        matrix(text, 1, "%.1f");
        return text.toString().getBytes(StandardCharsets.UTF_8);
    }

    private static void matrix(StringBuilder text, double scale, String format) {
        for (int row = 0; row < TestField.ROWS; row++) {
            for (int column = 0; column < TestField.COLUMNS; column++) {
                text.append(Text.format(format, scale * TestField.nanometers(column, row)));
                text.append(column + 1 < TestField.COLUMNS ? "\t" : "\n");
            }
        }
    }

    /** As WSxM exports points, from the bottom left, column by column. */
    static byte[] points() {
        StringBuilder text = new StringBuilder("WSxM file copyright\nWSxM ASCII XYZ file\nX[nm]   Y[nm]   Z[nm]\n\n");
        for (int column = 0; column < TestField.COLUMNS; column++) {
            for (int row = TestField.ROWS - 1; row >= 0; row--) {
                text.append("%d\t%d\t%d\n"
                        .formatted(500 * column, 400 * (TestField.ROWS - 1 - row), TestField.nanometers(column, row)));
            }
        }
        return text.toString().getBytes(StandardCharsets.UTF_8);
    }
}
