package sunbeam.precompute.scan.format;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.scan.ByteCursor;
import sunbeam.precompute.scan.Direction;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.SampleBlock;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.scan.ScanReader;

/**
 * Igor binary waves of version 5, as Asylum Research's microscopes write them: layers of one array are channels, their
 * labels the names. Columns run fastest; row 0 is the bottom. Source: WaveMetrics, "Igor Technical Note 003".
 */
final class IgorWaveReader implements ScanReader {
    private static final int BIN_HEADER = 64;
    private static final int WAVE_HEADER = 320;
    private static final int TYPE = BIN_HEADER + 16;
    private static final int DIMENSIONS = BIN_HEADER + 68;
    private static final int DATA_UNIT = BIN_HEADER + 148;
    private static final int LABEL = 32;
    private static final int LARGEST_TEXT = 1 << 20;

    @Override
    public String format() {
        return "Igor binary wave (.ibw)";
    }

    @Override
    public boolean recognises(ScanBytes file) throws IOException {
        byte[] head = file.head(2);
        return head.length == 2
                && ((head[0] == 5 && head[1] == 0) || (head[0] == 0 && head[1] == 5))
                && sumsToZero(file);
    }

    /** The two headers' 16-bit words, with the checksum among them, add up to zero. */
    private static boolean sumsToZero(ScanBytes file) throws IOException {
        if (file.size() < BIN_HEADER + WAVE_HEADER) {
            return false;
        }
        ByteCursor words = file.cursor(0, order(file));
        int sum = 0;
        while (words.position() < BIN_HEADER + WAVE_HEADER) {
            sum += words.int16();
        }
        return (sum & 0xffff) == 0;
    }

    private static ByteOrder order(ScanBytes file) throws IOException {
        return file.head(1)[0] == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    }

    @Override
    public List<ScanChannel> channels(ScanBytes file) throws IOException {
        ByteOrder order = order(file);
        ByteCursor cursor = file.cursor(8, order);
        // Sizes of what follows the samples: formula, note, units of the data and of four dimensions, labels of the
        // first two.
        long beforeLabels = 0;
        for (int i = 0; i < 9; i++) {
            beforeLabels += cursor.unsigned32();
        }
        long labels = cursor.unsigned32();
        cursor.moveTo(TYPE);
        SampleType type = type(cursor.int16());
        cursor.moveTo(DIMENSIONS);
        int columns = cursor.int32();
        int rows = cursor.int32();
        int layers = Math.max(1, cursor.int32());
        if (rows < 1) {
            throw new ScanException("holds a curve and no scan; choose the file of the image");
        }
        ScanLimits.requireChannels(layers);
        cursor.skip(Integer.BYTES);
        double pitchX = Math.abs(cursor.float64());
        double pitchY = Math.abs(cursor.float64());
        cursor.moveTo(DATA_UNIT);
        String unit = cursor.text(4);
        String unitXy = cursor.text(4);
        long count = (long) columns * rows;
        long data = BIN_HEADER + WAVE_HEADER;
        long texts = data + Math.multiplyExact(Math.multiplyExact(count, layers), type.size());
        file.requireInside(data, texts - data);
        List<String> names = names(file, texts + beforeLabels, labels, layers, order);
        Extent extent = Extent.ofPitches(pitchX, pitchY, unitXy, columns, rows);
        List<ScanChannel> channels = new ArrayList<>();
        for (int layer = 0; layer < layers; layer++) {
            String name = names.get(layer);
            channels.add(new ScanChannel(
                    name,
                    direction(name),
                    columns,
                    rows,
                    extent,
                    unit(name, unit),
                    SampleBlock.of(file, data + layer * count * type.size(), count, type, order)
                            .upsideDown(columns)));
        }
        return channels;
    }

    /** Labels of the layers; the first is that of the dimension itself. */
    private static List<String> names(ScanBytes file, long position, long bytes, int layers, ByteOrder order)
            throws IOException {
        List<String> names = new ArrayList<>();
        boolean there = bytes >= (long) LABEL * (layers + 1) && bytes <= LARGEST_TEXT;
        ByteCursor cursor = there ? file.cursor(position + LABEL, order) : null;
        for (int layer = 0; layer < layers; layer++) {
            names.add(there ? cursor.text(LABEL) : "");
        }
        return names;
    }

    private static Direction direction(String name) {
        return name.endsWith("Retrace")
                ? Direction.RETRACE
                : name.endsWith("Trace") ? Direction.TRACE : Direction.UNKNOWN;
    }

    /** The wave has one unit, metres, for all its layers: of phases and potentials it is not true. */
    private static String unit(String name, String unit) {
        if (name.startsWith("Phase")) {
            return "deg";
        }
        return name.contains("Potential") || name.startsWith("UserIn") || name.startsWith("Current") ? "V" : unit;
    }

    /** Igor's number types, without complex ones and text. */
    private static SampleType type(int code) {
        return switch (code) {
            case 0x02 -> SampleType.FLOAT_32;
            case 0x04 -> SampleType.FLOAT_64;
            case 0x08 -> SampleType.SIGNED_8;
            case 0x10 -> SampleType.SIGNED_16;
            case 0x20 -> SampleType.SIGNED_32;
            case 0x48 -> SampleType.UNSIGNED_8;
            case 0x50 -> SampleType.UNSIGNED_16;
            case 0x60 -> SampleType.UNSIGNED_32;
            default ->
                throw new ScanException(
                        String.format(Locale.ROOT, "holds numbers of Igor's type %d, which are no heights", code));
        };
    }
}
