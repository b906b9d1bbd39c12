package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.HeaderText;

/**
 * Gwyddion Simple Field: a header of {@code name = value} lines, one to four NULs up to a multiple of four bytes, then
 * 32-bit floats, little-endian, from the top row. Units are plain SI; without them a size means nothing. Source:
 * Gwyddion user guide, "Simple Field Files".
 */
final class SimpleFieldReader implements ScanReader {
    private static final String MAGIC = "Gwyddion Simple Field 1.0\n";
    private static final int LARGEST_HEADER = 1 << 20;

    @Override
    public String format() {
        return "Gwyddion Simple Field (.gsf)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith(MAGIC);
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        byte[] head = file.head(LARGEST_HEADER);
        int end = 0;
        while (end < head.length && head[end] != 0) {
            end++;
        }
        if (end == head.length) {
            throw new ScanException("has no NUL after its header; copy or export it again");
        }
        Map<String, String> values = values(new String(head, 0, end, StandardCharsets.UTF_8));
        int columns = HeaderText.integer(values, "XRes");
        int rows = HeaderText.integer(values, "YRes");
        Extent extent = Extent.ofPitches(
                HeaderText.number(values, "XReal", 1) / columns,
                HeaderText.number(values, "YReal", 1) / rows,
                values.getOrDefault("XYUnits", ""),
                columns,
                rows);
        long start = 4L * (end / 4 + 1);
        SampleBlock block = new SampleBlock(start, (long) columns * rows, SampleType.FLOAT_32, ByteOrder.LITTLE_ENDIAN)
                .requireIn(file);
        return List.of(new ScanChannel(
                values.getOrDefault("Title", ""),
                columns,
                rows,
                extent,
                values.getOrDefault("ZUnits", ""),
                () -> block.read(file)));
    }

    private static Map<String, String> values(String header) {
        Map<String, String> values = new HashMap<>();
        for (String line : header.lines().toList()) {
            int equals = line.indexOf('=');
            if (equals > 0) {
                values.put(
                        line.substring(0, equals).strip(),
                        line.substring(equals + 1).strip());
            }
        }
        return values;
    }
}
