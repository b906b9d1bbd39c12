package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;

/**
 * Reader of .mi files (Molecular Imaging, Agilent, Keysight): lines of a key padded to 14 characters and a value. The key bufferLabel
 * begins a channel; after the line "data" come the channels' little-endian integers, from the bottom row, whose full range stands for
 * -bufferRange to bufferRange. Source: sample files.
 */
final class AgilentReader {
    private static final int KEY_LENGTH = 14;
    private static final Map<String, SampleType> TYPES =
            Map.of("BINARY", SampleType.SIGNED_16, "BINARY_32", SampleType.SIGNED_32);

    private AgilentReader() {}

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        Header common = new Header();
        List<Header> buffers = new ArrayList<>();
        String head = file.headText(Header.LARGEST);
        int position = 0;
        while (!common.has("data")) {
            int end = head.indexOf('\n', position);
            if (end < 0) {
                throw new ScanException("has no line \"data\" after its header; copy or export it again");
            }
            String line = head.substring(position, end);
            String key = line.substring(0, Math.min(KEY_LENGTH, line.length())).strip();
            if (key.equals("bufferLabel")) {
                buffers.add(new Header());
            }
            boolean ofBuffer = !buffers.isEmpty() && !key.equals("data");
            Header list = ofBuffer ? buffers.get(buffers.size() - 1) : common;
            list.put(key, line.length() > KEY_LENGTH ? line.substring(KEY_LENGTH) : "");
            position = end + 1;
        }
        return channels(file, common, buffers, position);
    }

    private static List<ScanChannel> channels(ScanBytes file, Header common, List<Header> buffers, long start) {
        SampleType type = SampleType.of(TYPES, common.text("data", ""));
        Extent extent = Extent.of(common.number("xLength"), common.number("yLength"));
        List<ScanChannel> channels = new ArrayList<>();
        long offset = start;
        for (Header buffer : buffers) {
            Samples samples = Samples.of(file, offset, common.count("xPixels"), common.count("yPixels"), type);
            double factor = buffer.number("bufferRange") / Math.pow(2, 8.0 * type.size() - 1);
            channels.add(new ScanChannel(
                    buffer.text("bufferLabel", ""),
                    buffer.text("direction", "").equals("Retrace"),
                    samples.flipRows().scale(factor, 0),
                    extent,
                    buffer.text("bufferUnit", "")));
            offset += samples.count() * type.size();
        }
        return channels;
    }
}
