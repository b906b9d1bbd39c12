package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/**
 * Reader of Igor binary waves of version 5 (Asylum Research): layers are channels named by their labels, rows from the bottom. Source:
 * WaveMetrics, "Igor Technical Note 003".
 */
final class IgorWaveReader {
    // Lengths of the headers and positions of fields, bytes.
    private static final int FIRST_HEADER = 64;
    private static final int HEADERS = FIRST_HEADER + 320;
    private static final int TYPE = FIRST_HEADER + 16;
    private static final int DIMENSIONS = FIRST_HEADER + 68;
    private static final int DATA_UNIT = FIRST_HEADER + 148;
    private static final int LABEL_LENGTH = 32;
    private static final int LARGEST_TEXT = 1 << 20;

    private static final Map<Integer, SampleType> TYPES = Map.of(
            0x02, SampleType.FLOAT_32,
            0x04, SampleType.FLOAT_64,
            0x08, SampleType.SIGNED_8,
            0x10, SampleType.SIGNED_16,
            0x20, SampleType.SIGNED_32,
            0x48, SampleType.UNSIGNED_8,
            0x50, SampleType.UNSIGNED_16,
            0x60, SampleType.UNSIGNED_32);

    private IgorWaveReader() {}

    static boolean recognizes(ScanBytes file) throws IOException {
        byte[] head = file.head(2);
        return head.length == 2
                && ((head[0] == 5 && head[1] == 0) || (head[0] == 0 && head[1] == 5))
                && sumsToZero(file);
    }

    /** True if the 16-bit words of both headers, which include a checksum, add up to zero. */
    private static boolean sumsToZero(ScanBytes file) throws IOException {
        if (file.size() < HEADERS) {
            return false;
        }
        ScanBytes.Cursor words = file.cursor(0, order(file));
        int sum = 0;
        while (words.position() < HEADERS) {
            sum += words.int16();
        }
        return (sum & 0xffff) == 0;
    }

    private static ByteOrder order(ScanBytes file) throws IOException {
        return file.head(1)[0] == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    }

    static List<ScanChannel> channels(ScanBytes file) throws IOException {
        ByteOrder order = order(file);
        ScanBytes.Cursor cursor = file.cursor(8, order);
        // Nine parts lie between samples and layers' labels: formula, note, five units, labels of two dimensions.
        long beforeLabels = 0;
        for (int i = 0; i < 9; i++) {
            beforeLabels += cursor.unsigned32();
        }
        long labels = cursor.unsigned32();
        SampleType type = SampleType.of(TYPES, cursor.at(TYPE).int16());
        int columns = cursor.at(DIMENSIONS).int32();
        int rows = cursor.int32();
        int layers = Math.max(1, cursor.int32());
        if (rows < 1) {
            throw new ScanException("holds a curve and no scan; choose the file of the image");
        }
        ScanLimits.requireChannels(layers);
        ScanLimits.requireSize(columns, rows);
        cursor.skip(Integer.BYTES);
        double pitchX = Math.abs(cursor.float64());
        double pitchY = Math.abs(cursor.float64());
        String unit = cursor.at(DATA_UNIT).text(4);
        String unitXy = cursor.text(4);
        long bytes = (long) columns * rows * type.size();
        file.requireInside(HEADERS, bytes * layers);
        List<String> names = names(file, HEADERS + bytes * layers + beforeLabels, labels, layers, order);
        List<ScanChannel> channels = new ArrayList<>();
        for (String name : names) {
            Samples samples = Samples.of(file, HEADERS + bytes * channels.size(), columns, rows, type, order);
            Extent extent = Extent.ofPitches(pitchX, pitchY, unitXy, samples);
            channels.add(new ScanChannel(name, name.endsWith("Retrace"), samples.flipRows(), extent, unit(name, unit)));
        }
        return channels;
    }

    /** The label of the dimension precedes those of the layers. */
    private static List<String> names(ScanBytes file, long position, long bytes, int layers, ByteOrder order)
            throws IOException {
        List<String> names = new ArrayList<>();
        boolean hasLabels = bytes >= (long) LABEL_LENGTH * (layers + 1) && bytes <= LARGEST_TEXT;
        ScanBytes.Cursor cursor = hasLabels ? file.cursor(position + LABEL_LENGTH, order) : null;
        for (int layer = 0; layer < layers; layer++) {
            names.add(hasLabels ? cursor.text(LABEL_LENGTH) : "");
        }
        return names;
    }

    /** A wave has one unit, meters, even for layers of phases and potentials. */
    private static String unit(String name, String unit) {
        if (name.startsWith("Phase")) {
            return "deg";
        }
        return name.contains("Potential") || name.startsWith("UserIn") || name.startsWith("Current") ? "V" : unit;
    }
}
