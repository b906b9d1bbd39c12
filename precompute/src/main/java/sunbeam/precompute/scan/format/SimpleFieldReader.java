package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

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
        Header values = Header.of(new String(head, 0, end, StandardCharsets.UTF_8), '=');
        int columns = values.count("XRes");
        int rows = values.count("YRes");
        Extent extent = Extent.ofPitches(
                values.number("XReal", 1) / columns,
                values.number("YReal", 1) / rows,
                values.text("XYUnits", ""),
                columns,
                rows);
        long start = 4L * (end / 4 + 1);
        ScanChannel.Source samples =
                SampleBlock.of(file, start, (long) columns * rows, SampleType.FLOAT_32, ByteOrder.LITTLE_ENDIAN);
        return List.of(
                new ScanChannel(values.text("Title", ""), columns, rows, extent, values.text("ZUnits", ""), samples));
    }
}
