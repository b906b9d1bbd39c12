package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;

/**
 * Reader of Gwyddion Simple Field: a header of {@code name = value} lines, one to four NULs up to a multiple of four bytes, then 32-bit
 * floats, little-endian, from the top row. Units have no prefix; without a unit, a size is meaningless. Source: Gwyddion user guide,
 * "Simple Field Files".
 */
final class SimpleFieldReader {
    private SimpleFieldReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        int end = file.headBefore("\0").length();
        Header values = Header.of(new String(file.head(end), StandardCharsets.UTF_8), '=');
        long start = 4L * (end / 4 + 1);
        Samples samples = Samples.of(file, start, values.count("XRes"), values.count("YRes"), SampleType.FLOAT_32);
        Extent extent = Extent.ofSides(
                values.number("XReal", 1), values.number("YReal", 1), values.text("XYUnits", ""), samples);
        return List.of(new ScanChannel(values.text("Title", ""), samples, extent, values.text("ZUnits", "")));
    }
}
