package sunbeam.app.files.output;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;

/** Writer of NumPy's .npy format, version 1.0: float32, little endian, C order. */
public final class NpyWriter {
    private static final int ALIGNMENT = 64;
    private static final int PREFIX_BYTES = 10;
    private static final int BUFFER_VALUES = 1 << 14;
    // Earliest time in a zip file.
    private static final LocalDateTime ZIP_EPOCH = LocalDateTime.of(1980, 1, 1, 0, 0);

    private NpyWriter() {}

    /** Writes a whole array; a shape without dimensions is a single value. */
    public static void write(OutputStream stream, float[] values, int... shape) throws IOException {
        writeHeader(stream, shape);
        writeValues(stream, values);
    }

    /** Writes values after the header and those before them. */
    public static void writeValues(OutputStream stream, float[] values) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(BUFFER_VALUES * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (int done = 0; done < values.length; done += BUFFER_VALUES) {
            int portion = Math.min(BUFFER_VALUES, values.length - done);
            buffer.asFloatBuffer().put(values, done, portion);
            stream.write(buffer.array(), 0, portion * Float.BYTES);
        }
    }

    /** Returns an entry of a fixed time: equal contents give equal archives. */
    public static ZipEntry entry(String name) {
        ZipEntry entry = new ZipEntry(name);
        entry.setTimeLocal(ZIP_EPOCH);
        return entry;
    }

    public static void writeHeader(OutputStream stream, int... shape) throws IOException {
        // Python's tuples: (), (3,), (2, 3).
        String tuple = Arrays.stream(shape).mapToObj(Integer::toString).collect(Collectors.joining(", "));
        String dictionary =
                "{'descr': '<f4', 'fortran_order': False, 'shape': (" + tuple + (shape.length == 1 ? "," : "") + "), }";
        // Padded, so that the values are aligned.
        int length = PREFIX_BYTES + dictionary.length() + 1;
        int padding = (ALIGNMENT - length % ALIGNMENT) % ALIGNMENT;
        byte[] text = (dictionary + " ".repeat(padding) + "\n").getBytes(StandardCharsets.US_ASCII);
        ByteBuffer header = ByteBuffer.allocate(PREFIX_BYTES + text.length).order(ByteOrder.LITTLE_ENDIAN);
        header.put("\u0093NUMPY\1\0".getBytes(StandardCharsets.ISO_8859_1));
        stream.write(header.putShort((short) text.length).put(text).array());
    }
}
