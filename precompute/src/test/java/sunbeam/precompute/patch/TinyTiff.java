package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;

/** A TIFF composed of tags: unusual, damaged and hostile files that the JDK does not write. */
final class TinyTiff {
    static final int WIDTH = 256;
    static final int LENGTH = 257;
    static final int BITS = 258;
    static final int COMPRESSION = 259;
    static final int PHOTOMETRIC = 262;
    static final int STRIP_OFFSETS = 273;
    static final int ORIENTATION = 274;
    static final int CHANNELS = 277;
    static final int ROWS_PER_STRIP = 278;
    static final int STRIP_BYTES = 279;
    static final int TILE_WIDTH = 322;
    static final int TILE_LENGTH = 323;
    static final int SAMPLE_FORMAT = 339;

    private static final int TYPE_SHORT = 3;
    private static final int TYPE_LONG = 4;
    private static final int HEADER_BYTES = 8;

    private final Map<Integer, Integer> tags = new TreeMap<>();
    private final byte[] data;

    /** A gray, uncompressed image in one strip, little-endian. */
    TinyTiff(int columns, int rows, int bits, byte[] data) {
        this.data = data;
        tags.putAll(Map.of(WIDTH, columns, LENGTH, rows, BITS, bits, COMPRESSION, 1, PHOTOMETRIC, 1));
        tags.putAll(Map.of(STRIP_OFFSETS, HEADER_BYTES, CHANNELS, 1, ROWS_PER_STRIP, rows, STRIP_BYTES, data.length));
    }

    TinyTiff with(int tag, int value) {
        tags.put(tag, value);
        return this;
    }

    Path write(Path file) throws IOException {
        ByteBuffer out = ByteBuffer.allocate(HEADER_BYTES + data.length + 2 + 12 * tags.size() + 4)
                .order(ByteOrder.LITTLE_ENDIAN);
        out.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(HEADER_BYTES + data.length);
        out.put(data).putShort((short) tags.size());
        tags.forEach((tag, value) -> out.putShort(tag.shortValue())
                // Most tags must be short; sizes and offsets may be long.
                .putShort((short) (value < 1 << 16 ? TYPE_SHORT : TYPE_LONG))
                .putInt(1)
                .putInt(value));
        out.putInt(0);
        return Files.write(file, out.array());
    }
}
