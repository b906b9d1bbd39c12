package sunbeam.precompute.scan;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reader of .gwy files by Gwyddion: a container of objects, little-endian. Channel n is the data field {@code /n/data} with the title
 * {@code /n/data/title}. Source: Gwyddion user guide, "Gwyddion native data files".
 */
final class GwyddionReader {
    private static final Pattern FIELD = Pattern.compile("/(\\d{1,9})/data");

    private GwyddionReader() {}

    /** Doubles in the file from a position in bytes on. */
    private record Numbers(long offset, long count) {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        ScanException.refuseIf(
                file.startsWith("GWYO"), "was written by Gwyddion 1, before 2006; save it again with Gwyddion 2");
        GwyddionObject container = GwyddionObject.read(file, file.cursor(4, ByteOrder.LITTLE_ENDIAN), 0);
        Map<Integer, ScanChannel> channels = new TreeMap<>();
        for (Map.Entry<String, Object> item : container.items().entrySet()) {
            Matcher field = FIELD.matcher(item.getKey());
            if (field.matches() && item.getValue() instanceof GwyddionObject object) {
                String title = container.text(item.getKey() + "/title");
                channels.put(Integer.valueOf(field.group(1)), channel(file, title, object));
            }
        }
        return new ArrayList<>(channels.values());
    }

    /**
     * Reads a Gwyddion Simple Field: {@code name = value} lines, NULs up to a multiple of four bytes, then little-endian floats from the
     * top row. Source: Gwyddion user guide, "Simple Field Files".
     */
    static List<ScanChannel> simpleField(ScanBytes file) throws IOException {
        int end = file.headBefore("\0").length();
        Header values = Header.of(new String(file.head(end), StandardCharsets.UTF_8), '=');
        long start = 4L * (end / 4 + 1);
        int columns = values.count("XRes");
        int rows = values.count("YRes");
        Samples samples = Samples.of(file, start, columns, rows, SampleType.FLOAT_32);
        ScanException.refuseIf(
                file.size() - start != (long) Float.BYTES * columns * rows,
                "announces " + columns + " x " + rows + " samples of 4 bytes, but has " + (file.size() - start)
                        + " bytes of them; export it again");
        Extent extent = Extent.ofSides(
                values.number("XReal", 1), values.number("YReal", 1), values.text("XYUnits", ""), samples);
        return List.of(new ScanChannel(values.text("Title", ""), samples, extent, values.text("ZUnits", "")));
    }

    private static ScanChannel channel(ScanBytes file, String title, GwyddionObject field) {
        int columns = field.get("xres", Integer.class);
        int rows = field.get("yres", Integer.class);
        Numbers data = field.get("data", Numbers.class);
        if (data.count() != (long) columns * rows) {
            throw new ScanException("has " + data.count() + " samples where " + columns + " x " + rows
                    + " are announced; the file is damaged, export it again");
        }
        Samples samples = Samples.of(file, data.offset(), columns, rows, SampleType.FLOAT_64);
        Extent extent =
                Extent.ofSides(field.number("xreal", 1), field.number("yreal", 1), field.unit("si_unit_xy"), samples);
        return new ScanChannel(title, samples, extent, field.unit("si_unit_z"));
    }

    /** Type name, size, then components: name, letter of the type, value (Integer, Double, String, {@link Numbers} or GwyddionObject). */
    private record GwyddionObject(Map<String, Object> items) {
        // Known files nest three levels deep; hostile ones could overflow the stack.
        private static final int DEEPEST = 8;
        private static final int MOST_ITEMS = 100_000;
        private static final int LONGEST_NAME = 4096;
        private static final int LONGEST_TEXT = 1 << 20;

        static GwyddionObject read(ScanBytes file, ScanBytes.Cursor cursor, int depth) throws IOException {
            ScanException.refuseIf(
                    depth > DEEPEST, "nests objects more than " + DEEPEST + " deep; save it anew with Gwyddion");
            cursor.textToNul(LONGEST_NAME);
            long size = cursor.unsigned32();
            file.requireInside(cursor.position(), size);
            long end = cursor.position() + size;
            Map<String, Object> items = new LinkedHashMap<>();
            while (cursor.position() < end) {
                if (items.size() > MOST_ITEMS) {
                    throw new ScanException("has more than " + MOST_ITEMS + " parts; save its height channel alone");
                }
                String name = cursor.textToNul(LONGEST_NAME);
                Object value = value(file, cursor, (char) cursor.unsignedByte(), depth);
                if (value != null) {
                    items.put(name, value);
                }
            }
            ScanException.refuseIf(
                    cursor.position() != end,
                    "has parts that overlap at position " + end + "; the file is damaged, save it again");
            return new GwyddionObject(items);
        }

        private static Object value(ScanBytes file, ScanBytes.Cursor cursor, char type, int depth) throws IOException {
            return switch (type) {
                case 'i' -> cursor.int32();
                case 'd' -> cursor.float64();
                case 's' -> cursor.textToNul(LONGEST_TEXT);
                case 'o' -> read(file, cursor, depth + 1);
                case 'D' -> {
                    long count = cursor.unsigned32();
                    Numbers numbers = new Numbers(cursor.position(), count);
                    cursor.skip(Double.BYTES * count);
                    yield numbers;
                }
                default -> {
                    skip(cursor, type);
                    yield null;
                }
            };
        }

        private static void skip(ScanBytes.Cursor cursor, char type) throws IOException {
            switch (type) {
                case 'b', 'c' -> cursor.skip(1);
                case 'q' -> cursor.skip(Long.BYTES);
                case 'C' -> cursor.skip(cursor.unsigned32());
                case 'I' -> cursor.skip(Integer.BYTES * cursor.unsigned32());
                case 'Q' -> cursor.skip(Long.BYTES * cursor.unsigned32());
                case 'S', 'O' -> {
                    for (long i = cursor.unsigned32(); i > 0; i--) {
                        cursor.textToNul(type == 'S' ? LONGEST_TEXT : LONGEST_NAME);
                        cursor.skip(type == 'S' ? 0 : cursor.unsigned32());
                    }
                }
                default ->
                    throw new ScanException("has a part of the unknown type '" + type + "' at position "
                            + (cursor.position() - 1) + "; save it anew with Gwyddion");
            }
        }

        <T> T get(String name, Class<T> type) {
            if (type.isInstance(items.get(name))) {
                return type.cast(items.get(name));
            }
            throw new ScanException("has a data field without " + name + "; save it anew with Gwyddion");
        }

        double number(String name, double otherwise) {
            return items.get(name) instanceof Double value ? value : otherwise;
        }

        String text(String name) {
            return items.get(name) instanceof String text ? text : "";
        }

        String unit(String name) {
            return items.get(name) instanceof GwyddionObject unit ? unit.text("unitstr") : "";
        }
    }
}
