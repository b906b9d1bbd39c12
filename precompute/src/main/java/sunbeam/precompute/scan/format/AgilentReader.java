package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.scan.Direction;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Header;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;

/**
 * Molecular Imaging, Agilent and Keysight .mi: lines of a key padded to 14 characters and a value; a list of buffers,
 * each of which begins with bufferLabel; after "data" the buffers' 16- or 32-bit integers, little-endian, from the bottom
 * row. The range of integers is bufferRange to both sides of zero. Source: files.
 */
final class AgilentReader implements ScanReader {
    private static final String MAGIC = "fileType      Image";
    private static final int KEY = 14;
    private static final int LARGEST_HEADER = 1 << 20;

    @Override
    public String format() {
        return "Molecular Imaging (.mi)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        return file.startsWith(MAGIC);
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        Header all = new Header();
        List<Header> buffers = new ArrayList<>();
        String head = file.headText(LARGEST_HEADER);
        int position = 0;
        while (!all.has("data")) {
            int end = head.indexOf('\n', position);
            if (end < 0) {
                throw new ScanException("has no line \"data\" after its header; copy or export it again");
            }
            String line = head.substring(position, end);
            String key = line.substring(0, Math.min(KEY, line.length())).strip();
            if (key.equals("bufferLabel")) {
                buffers.add(new Header());
            }
            boolean ofBuffer = !buffers.isEmpty() && !key.equals("data");
            Header list = ofBuffer ? buffers.get(buffers.size() - 1) : all;
            list.put(key, line.length() > KEY ? line.substring(KEY) : "");
            position = end + 1;
        }
        return channels(file, all, buffers, position);
    }

    private static List<ScanChannel> channels(ScanBytes file, Header all, List<Header> buffers, long start) {
        SampleType type = switch (all.text("data", "")) {
            case "BINARY" -> SampleType.SIGNED_16;
            case "BINARY_32" -> SampleType.SIGNED_32;
            default ->
                throw new ScanException(
                        "stores its samples as " + all.text("data", "") + "; export it in binary or another format");
        };
        int columns = all.count("xPixels");
        int rows = all.count("yPixels");
        Extent extent = Extent.of(all.number("xLength"), all.number("yLength"));
        long count = (long) columns * rows;
        List<ScanChannel> channels = new ArrayList<>();
        for (Header buffer : buffers) {
            long offset = start + channels.size() * count * type.size();
            double factor = buffer.number("bufferRange") / Math.pow(2, 8.0 * type.size() - 1);
            channels.add(new ScanChannel(
                    buffer.text("bufferLabel", ""),
                    direction(buffer.text("direction", "")),
                    columns,
                    rows,
                    extent,
                    buffer.text("bufferUnit", ""),
                    SampleBlock.of(file, offset, count, type, ByteOrder.LITTLE_ENDIAN)
                            .upsideDown(columns)
                            .scaled(factor, 0)));
        }
        return channels;
    }

    private static Direction direction(String word) {
        return switch (word) {
            case "Trace" -> Direction.TRACE;
            case "Retrace" -> Direction.RETRACE;
            default -> Direction.UNKNOWN;
        };
    }
}
