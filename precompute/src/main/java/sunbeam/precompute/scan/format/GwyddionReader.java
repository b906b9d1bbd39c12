package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Gwyddion's own files: a container of objects, little-endian. Channel n is the object {@code /n/data}, a data field;
 * its title stands in {@code /n/data/title}. Source: Gwyddion user guide, "Gwyddion native data files".
 */
final class GwyddionReader {
    private static final Pattern FIELD = Pattern.compile("/(\\d{1,9})/data");

    private GwyddionReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        if (file.startsWith("GWYO")) {
            throw new ScanException(
                    "was written by Gwyddion 1, which nobody has used since 2006; save it anew with Gwyddion 2");
        }
        GwyddionObject container = GwyddionObject.read(file, file.cursor(4, ByteOrder.LITTLE_ENDIAN));
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

    private static ScanChannel channel(ScanBytes file, String title, GwyddionObject field) {
        int columns = field.get("xres", Integer.class);
        int rows = field.get("yres", Integer.class);
        GwyddionObject.Numbers data = field.get("data", GwyddionObject.Numbers.class);
        if (data.count() != (long) columns * rows) {
            throw new ScanException("has " + data.count() + " samples where " + columns + " x " + rows
                    + " are announced; the file is damaged, export it again");
        }
        Samples samples = Samples.of(file, data.offset(), columns, rows, SampleType.FLOAT_64);
        Extent extent =
                Extent.ofSides(field.number("xreal", 1), field.number("yreal", 1), field.unit("si_unit_xy"), samples);
        return new ScanChannel(title, samples, extent, field.unit("si_unit_z"));
    }
}
