package sunbeam.app.cli.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A texture file in Khronos's format KTX 2.0: an array of two-dimensional textures of four half floats, with mip levels.
 *
 * @param layers array layers of each level
 * @param levels half floats, the finest level first; layer by layer, row by row from the bottom
 * @param metadata text that is stored under the key {@code sunbeam}
 */
record Ktx2File(int width, int height, int layers, List<short[]> levels, String metadata) {
    private static final byte[] IDENTIFIER = {
        (byte) 0xab, 'K', 'T', 'X', ' ', '2', '0', (byte) 0xbb, '\r', '\n', 0x1a, '\n'
    };
    private static final int R16G16B16A16_SFLOAT = 97;
    private static final int CHANNELS = 4;
    private static final int TEXEL_BYTES = CHANNELS * Short.BYTES;
    private static final int HEADER_BYTES = 80;
    private static final int LEVEL_BYTES = 24;
    private static final int SAMPLE_BYTES = 16;
    private static final int DESCRIPTOR_BYTES = 24 + CHANNELS * SAMPLE_BYTES;

    void write(OutputStream stream) throws IOException {
        byte[] keys = keys();
        int descriptor = HEADER_BYTES + LEVEL_BYTES * levels.size();
        int keysAt = descriptor + Integer.BYTES + DESCRIPTOR_BYTES;
        int dataAt = (keysAt + keys.length + TEXEL_BYTES - 1) / TEXEL_BYTES * TEXEL_BYTES;
        ByteBuffer head = ByteBuffer.allocate(dataAt).order(ByteOrder.LITTLE_ENDIAN);
        head.put(IDENTIFIER);
        // Fields: format, bytes of a number, width, height, no depth, layers, one face, levels, no compression.
        ints(head, R16G16B16A16_SFLOAT, Short.BYTES, width, height, 0, layers, 1, levels.size(), 0);
        ints(head, descriptor, Integer.BYTES + DESCRIPTOR_BYTES, keysAt, keys.length);
        head.putLong(0).putLong(0);
        long at = dataAt;
        for (int level = levels.size() - 1; level >= 0; level--) {
            head.putLong(HEADER_BYTES + LEVEL_BYTES * level, at);
            at += bytes(level);
        }
        for (int level = 0; level < levels.size(); level++) {
            head.position(HEADER_BYTES + LEVEL_BYTES * level + Long.BYTES);
            head.putLong(bytes(level)).putLong(bytes(level));
        }
        describe(head);
        head.put(keys);
        stream.write(head.array());
        // KTX2 stores the smallest level first.
        for (int level = levels.size() - 1; level >= 0; level--) {
            short[] values = levels.get(level);
            ByteBuffer bytes = ByteBuffer.allocate(values.length * Short.BYTES).order(ByteOrder.LITTLE_ENDIAN);
            bytes.asShortBuffer().put(values);
            stream.write(bytes.array());
        }
    }

    private long bytes(int level) {
        return (long) levels.get(level).length * Short.BYTES;
    }

    /** Writes Khronos's basic data format descriptor: linear, four signed floats of 16 bits. */
    private static void describe(ByteBuffer head) {
        ints(head, Integer.BYTES + DESCRIPTOR_BYTES, 0, 2 | DESCRIPTOR_BYTES << Short.SIZE);
        // Fields: color model RGBSDA, linear, alpha straight; blocks of one texel; bytes per texel.
        ints(head, 1 | 1 << Short.SIZE, 0, TEXEL_BYTES, 0);
        for (int channel = 0; channel < CHANNELS; channel++) {
            int kind = channel == CHANNELS - 1 ? 15 : channel;
            // Fields: bit offset, bit length, channel and signed float; position; least and largest value, -1 and 1.
            ints(head, 16 * channel | 15 << 16 | (kind | 0xc0) << 24, 0, 0xbf800000, 0x3f800000);
        }
    }

    private static void ints(ByteBuffer buffer, int... values) {
        for (int value : values) {
            buffer.putInt(value);
        }
    }

    private byte[] keys() {
        byte[] writer = "KTXwriter\0sunbeam\0".getBytes(StandardCharsets.UTF_8);
        byte[] text = ("sunbeam\0" + metadata + "\0").getBytes(StandardCharsets.UTF_8);
        ByteBuffer keys = ByteBuffer.allocate(2 * Integer.BYTES + padded(writer) + padded(text))
                .order(ByteOrder.LITTLE_ENDIAN);
        keys.putInt(writer.length).put(writer).position(Integer.BYTES + padded(writer));
        keys.putInt(text.length).put(text);
        return keys.array();
    }

    private static int padded(byte[] bytes) {
        return (bytes.length + Integer.BYTES - 1) / Integer.BYTES * Integer.BYTES;
    }
}
