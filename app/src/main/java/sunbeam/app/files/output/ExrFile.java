package sunbeam.app.files.output;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ObjIntConsumer;
import java.util.zip.Deflater;

/**
 * File in OpenEXR 2 format: scan lines in ZIP blocks of 16.
 *
 * @param channels one letter each, in the order of the samples: against the alphabet, in which the file has them
 * @param samples writer of the sample with an index: row by row from the top, the channels of a pixel side by side
 */
public record ExrFile(
        int width, int height, String channels, int type, ObjIntConsumer<ByteBuffer> samples, String comments) {
    private static final int MAGIC = 20000630;
    private static final int VERSION = 2;
    private static final int ZIP = 3;
    private static final int BLOCK_LINES = 16;
    // Types of samples; their bytes are twice these numbers.
    private static final int HALF = 1;
    private static final int FLOAT = 2;

    /** Returns a file of red, green and blue as bits of half floats, row by row from the top. */
    public static ExrFile ofHalves(int width, int height, short[] rgb, String comments) {
        return new ExrFile(width, height, "RGB", HALF, (bytes, index) -> bytes.putShort(rgb[index]), comments);
    }

    /** Returns a file of red, green, blue and alpha, row by row from the top. */
    public static ExrFile ofFloats(int width, int height, float[] rgba, String comments) {
        return new ExrFile(width, height, "RGBA", FLOAT, (bytes, index) -> bytes.putFloat(rgba[index]), comments);
    }

    public void write(OutputStream stream) throws IOException {
        byte[] header = header();
        List<byte[]> blocks = new ArrayList<>();
        for (int line = 0; line < height; line += BLOCK_LINES) {
            blocks.add(block(line, Math.min(height, line + BLOCK_LINES)));
        }
        stream.write(header);
        ByteBuffer offsets = ByteBuffer.allocate(Long.BYTES * blocks.size()).order(ByteOrder.LITTLE_ENDIAN);
        long at = header.length + (long) offsets.capacity();
        for (byte[] block : blocks) {
            offsets.putLong(at);
            at += block.length;
        }
        stream.write(offsets.array());
        for (byte[] block : blocks) {
            stream.write(block);
        }
    }

    private byte[] header() throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        header.write(ints(MAGIC, VERSION));
        ByteArrayOutputStream list = new ByteArrayOutputStream();
        for (int channel = channels.length() - 1; channel >= 0; channel--) {
            list.write(text(channels.substring(channel, channel + 1)));
            list.write(ints(type, 0, 1, 1));
        }
        list.write(0);
        attribute(header, "channels", "chlist", list.toByteArray());
        attribute(header, "comments", "string", comments.getBytes(StandardCharsets.UTF_8));
        attribute(header, "compression", "compression", new byte[] {ZIP});
        attribute(header, "dataWindow", "box2i", ints(0, 0, width - 1, height - 1));
        attribute(header, "displayWindow", "box2i", ints(0, 0, width - 1, height - 1));
        attribute(header, "lineOrder", "lineOrder", new byte[] {0});
        int one = Float.floatToIntBits(1);
        attribute(header, "pixelAspectRatio", "float", ints(one));
        attribute(header, "screenWindowCenter", "v2f", ints(0, 0));
        attribute(header, "screenWindowWidth", "float", ints(one));
        header.write(0);
        return header.toByteArray();
    }

    private static void attribute(ByteArrayOutputStream header, String name, String type, byte[] value)
            throws IOException {
        header.write(text(name));
        header.write(text(type));
        header.write(ints(value.length));
        header.write(value);
    }

    /** Number of its first line, length in bytes, and the lines, each with one channel after the other. */
    private byte[] block(int from, int to) {
        int count = channels.length();
        ByteBuffer lines =
                ByteBuffer.allocate((to - from) * width * count * 2 * type).order(ByteOrder.LITTLE_ENDIAN);
        for (int line = from; line < to; line++) {
            for (int channel = count - 1; channel >= 0; channel--) {
                for (int x = 0; x < width; x++) {
                    samples.accept(lines, (line * width + x) * count + channel);
                }
            }
        }
        byte[] raw = lines.array();
        byte[] packed = packed(raw);
        byte[] shorter = packed.length < raw.length ? packed : raw;
        ByteBuffer block =
                ByteBuffer.allocate(2 * Integer.BYTES + shorter.length).order(ByteOrder.LITTLE_ENDIAN);
        return block.putInt(from).putInt(shorter.length).put(shorter).array();
    }

    /** Bytes at even, then at odd positions, as differences plus 128, deflated. */
    private static byte[] packed(byte[] raw) {
        byte[] separated = new byte[raw.length];
        int half = (raw.length + 1) / 2;
        for (int i = 0; i < raw.length; i++) {
            separated[i % 2 == 0 ? i / 2 : half + i / 2] = raw[i];
        }
        for (int i = separated.length - 1; i > 0; i--) {
            separated[i] = (byte) (separated[i] - separated[i - 1] + 128);
        }
        return deflated(separated, Deflater.DEFAULT_COMPRESSION);
    }

    /** Returns zlib's format; {@code effort} is a level of {@link Deflater}, 0 to 9 or -1. */
    public static byte[] deflated(byte[] bytes, int effort) {
        Deflater deflater = new Deflater(effort);
        try {
            deflater.setInput(bytes);
            deflater.finish();
            ByteArrayOutputStream packed = new ByteArrayOutputStream();
            byte[] buffer = new byte[1 << 16];
            while (!deflater.finished()) {
                packed.write(buffer, 0, deflater.deflate(buffer));
            }
            return packed.toByteArray();
        } finally {
            deflater.end();
        }
    }

    private static byte[] ints(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asIntBuffer().put(values);
        return bytes.array();
    }

    private static byte[] text(String text) {
        return (text + "\0").getBytes(StandardCharsets.US_ASCII);
    }
}
