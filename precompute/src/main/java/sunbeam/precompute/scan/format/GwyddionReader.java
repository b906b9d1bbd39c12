package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * Gwyddion's own files: a container of objects, little-endian. Channel n is the object {@code /n/data}, a data field;
 * its title stands in {@code /n/data/title}. Source: Gwyddion user guide, "Gwyddion native data files".
 */
final class GwyddionReader implements ScanReader {
    private static final Pattern FIELD = Pattern.compile("/(\\d{1,9})/data");
    private static final Pattern TITLE = Pattern.compile("/(\\d{1,9})/data/title");

    @Override
    public String format() {
        return "Gwyddion (.gwy)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith("GWYP") || file.startsWith("GWYO");
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        if (file.startsWith("GWYO")) {
            throw new ScanException(
                    "was written by Gwyddion 1, which nobody has used since 2006; save it anew with" + " Gwyddion 2");
        }
        GwyddionObject container = GwyddionObject.read(file, file.cursor(4, ByteOrder.LITTLE_ENDIAN));
        Map<Integer, GwyddionObject> fields = new TreeMap<>();
        Map<Integer, String> titles = new TreeMap<>();
        for (Map.Entry<String, Object> item : container.items().entrySet()) {
            Matcher field = FIELD.matcher(item.getKey());
            Matcher title = TITLE.matcher(item.getKey());
            if (field.matches() && item.getValue() instanceof GwyddionObject object) {
                fields.put(Integer.valueOf(field.group(1)), object);
            } else if (title.matches() && item.getValue() instanceof String text) {
                titles.put(Integer.valueOf(title.group(1)), text);
            }
        }
        List<ScanChannel> channels = new ArrayList<>();
        for (Map.Entry<Integer, GwyddionObject> field : fields.entrySet()) {
            channels.add(channel(file, titles.getOrDefault(field.getKey(), ""), field.getValue()));
        }
        return channels;
    }

    private static ScanChannel channel(ScanBytes file, String title, GwyddionObject field) {
        int columns = field.integer("xres");
        int rows = field.integer("yres");
        GwyddionObject.Numbers data = field.numbers("data");
        if (data.count() != (long) columns * rows) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %d samples where %d x %d are announced; the file is damaged, export it again",
                    data.count(),
                    columns,
                    rows));
        }
        ScanChannel.Source samples =
                SampleBlock.of(file, data.offset(), data.count(), SampleType.FLOAT_64, ByteOrder.LITTLE_ENDIAN);
        Extent extent = Extent.ofPitches(
                field.number("xreal", 1) / columns,
                field.number("yreal", 1) / rows,
                field.unit("si_unit_xy"),
                columns,
                rows);
        return new ScanChannel(title, columns, rows, extent, field.unit("si_unit_z"), samples);
    }
}
