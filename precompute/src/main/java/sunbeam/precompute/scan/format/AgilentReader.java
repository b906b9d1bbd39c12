package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.Direction;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.text.HeaderText;

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
        Map<String, String> all = new HashMap<>();
        List<Map<String, String>> buffers = new ArrayList<>();
        Map<String, String> list = all;
        String head = file.headText(LARGEST_HEADER);
        int position = 0;
        while (!all.containsKey("data")) {
            int end = head.indexOf('\n', position);
            if (end < 0) {
                throw new ScanException("has no line \"data\" after its header; copy or export it again");
            }
            String line = head.substring(position, end);
            String key = line.substring(0, Math.min(KEY, line.length())).strip();
            String value = line.length() > KEY ? line.substring(KEY).strip() : "";
            if (key.equals("bufferLabel")) {
                list = new HashMap<>();
                buffers.add(list);
            }
            (key.equals("data") ? all : list).put(key, value);
            position = end + 1;
        }
        return channels(file, all, buffers, position);
    }

    private static List<ScanChannel> channels(
            ScanBytes file, Map<String, String> all, List<Map<String, String>> buffers, long start) {
        SampleType type = switch (all.get("data")) {
            case "BINARY" -> SampleType.SIGNED_16;
            case "BINARY_32" -> SampleType.SIGNED_32;
            default ->
                throw new ScanException(
                        "stores its samples as " + all.get("data") + "; export it in binary or another format");
        };
        int columns = HeaderText.integer(all, "xPixels");
        int rows = HeaderText.integer(all, "yPixels");
        Extent extent = Extent.of(HeaderText.number(all, "xLength"), HeaderText.number(all, "yLength"));
        long count = (long) columns * rows;
        List<ScanChannel> channels = new ArrayList<>();
        for (int i = 0; i < buffers.size(); i++) {
            Map<String, String> buffer = buffers.get(i);
            SampleBlock block = new SampleBlock(start + i * count * type.size(), count, type, ByteOrder.LITTLE_ENDIAN)
                    .requireIn(file);
            double factor = HeaderText.number(buffer, "bufferRange") / Math.pow(2, 8.0 * type.size() - 1);
            channels.add(new ScanChannel(
                    buffer.get("bufferLabel"),
                    direction(buffer.getOrDefault("direction", "")),
                    columns,
                    rows,
                    extent,
                    buffer.getOrDefault("bufferUnit", ""),
                    () -> Samples.scaled(Samples.upsideDown(block.read(file), columns), factor, 0)));
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
