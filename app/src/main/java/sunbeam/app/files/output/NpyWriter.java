package sunbeam.app.files.output;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;

/**
 * NumPy's .npy format, version 1.0: float32, little endian, C order (the last index runs fastest), any rank. The values
 * are streamed: hand them over in pieces of any length, then close.
 */
public final class NpyWriter implements AutoCloseable {
    private static final int ALIGNMENT = 64;
    private static final int PREFIX_BYTES = 10;
    private static final int BUFFER_VALUES = 1 << 14;

    private final OutputStream stream;
    private final ByteBuffer buffer =
            ByteBuffer.allocate(BUFFER_VALUES * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    private long missing;

    /**
     * Writes the header.
     *
     * @param stream stays open when this is closed
     * @param shape length of each dimension, none negative; empty for a single value
     */
    public NpyWriter(OutputStream stream, int... shape) throws IOException {
        this.stream = stream;
        this.missing = 1;
        for (int length : shape) {
            if (length < 0) {
                throw new IllegalArgumentException("not a shape: " + Arrays.toString(shape));
            }
            missing = Math.multiplyExact(missing, (long) length);
        }
        stream.write(header(shape));
    }

    /**
     * Writes a whole array to a file, whole or not at all.
     *
     * @throws OutputException when the file cannot be written
     */
    public static void write(Path target, Overwrite overwrite, float[] values, int... shape) {
        AtomicFile.write(target, overwrite, stream -> write(stream, values, shape));
    }

    /** As {@link #write(Path, Overwrite, float[], int...)}, to a stream, which stays open. */
    public static void write(OutputStream stream, float[] values, int... shape) throws IOException {
        try (NpyWriter writer = new NpyWriter(stream, shape)) {
            writer.append(values, 0, values.length);
        }
    }

    /** Writes {@code count} values, beginning with {@code values[first]}. */
    public void append(float[] values, int first, int count) throws IOException {
        if (count > missing) {
            throw new IllegalArgumentException(count + " values, where the shape has room for " + missing);
        }
        missing -= count;
        for (int done = 0; done < count; done += BUFFER_VALUES) {
            int portion = Math.min(BUFFER_VALUES, count - done);
            buffer.asFloatBuffer().put(values, first + done, portion);
            stream.write(buffer.array(), 0, portion * Float.BYTES);
        }
    }

    /**
     * Checks that the array is complete.
     *
     * @throws IllegalStateException when values that the shape promises were not written
     */
    @Override
    public void close() {
        if (missing != 0) {
            throw new IllegalStateException(missing + " values were not written");
        }
    }

    private static byte[] header(int... shape) {
        // Python's tuples: (), (3,), (2, 3)
        String tuple = Arrays.stream(shape).mapToObj(Integer::toString).collect(Collectors.joining(", "));
        String dictionary =
                "{'descr': '<f4', 'fortran_order': False, 'shape': (" + tuple + (shape.length == 1 ? "," : "") + "), }";
        // Blanks and a line feed fill the header up, so that the values are aligned.
        int length = PREFIX_BYTES + dictionary.length() + 1;
        int padding = (ALIGNMENT - length % ALIGNMENT) % ALIGNMENT;
        byte[] text = (dictionary + " ".repeat(padding) + "\n").getBytes(StandardCharsets.US_ASCII);
        return ByteBuffer.allocate(PREFIX_BYTES + text.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put((byte) 0x93)
                .put("NUMPY".getBytes(StandardCharsets.US_ASCII))
                .put((byte) 1)
                .put((byte) 0)
                .putShort((short) text.length)
                .put(text)
                .array();
    }
}
