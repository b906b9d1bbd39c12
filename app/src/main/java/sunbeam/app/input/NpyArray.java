package sunbeam.app.input;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A float32 array from a .npy file (version 1.0, little endian, C order), such as Sunbeam writes. */
public final class NpyArray {
    private static final int PREFIX_BYTES = 10;
    private static final Pattern DICTIONARY =
            Pattern.compile("\\{'descr': '<f4', 'fortran_order': False, 'shape': \\(([0-9, ]*)\\), \\}\\s*");

    private final List<Integer> shape;
    private final float[] values;

    private NpyArray(List<Integer> shape, float[] values) {
        this.shape = shape;
        this.values = values;
    }

    /**
     * Reads a file.
     *
     * @throws InputException when it is missing, of another kind, or not as long as its header says
     */
    public static NpyArray read(Path file) {
        try (InputStream stream = Files.newInputStream(file)) {
            return read(file, new DataInputStream(stream), Files.size(file));
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    /** Length of each dimension. */
    public List<Integer> shape() {
        return shape;
    }

    /** The value at an index, which has as many parts as the shape. */
    public float at(int... index) {
        if (index.length != shape.size()) {
            throw new IllegalArgumentException(Arrays.toString(index) + " is no index into " + shape);
        }
        int position = 0;
        for (int dimension = 0; dimension < index.length; dimension++) {
            int length = shape.get(dimension);
            if (index[dimension] < 0 || index[dimension] >= length) {
                throw new IndexOutOfBoundsException(Arrays.toString(index) + " lies outside " + shape);
            }
            position = position * length + index[dimension];
        }
        return values[position];
    }

    /** A copy of all values, the last index running fastest. */
    public float[] toArray() {
        return values.clone();
    }

    private static NpyArray read(Path file, DataInputStream stream, long fileBytes) throws IOException {
        byte[] prefix = stream.readNBytes(PREFIX_BYTES);
        byte[] expected = {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0};
        if (prefix.length < PREFIX_BYTES || !Arrays.equals(prefix, 0, expected.length, expected, 0, expected.length)) {
            throw new InputException("cannot read " + file + ": not a .npy file of version 1.0");
        }
        int headerBytes = Short.toUnsignedInt(
                ByteBuffer.wrap(prefix).order(ByteOrder.LITTLE_ENDIAN).getShort(expected.length));
        String header = new String(stream.readNBytes(headerBytes), StandardCharsets.US_ASCII);
        Matcher dictionary = DICTIONARY.matcher(header);
        if (!dictionary.matches()) {
            throw new InputException("cannot read " + file + ": not a float32 array in C order: " + header.strip());
        }
        List<Integer> shape = shape(file, dictionary.group(1));
        long valueBytes = fileBytes - PREFIX_BYTES - headerBytes;
        return new NpyArray(shape, values(stream, count(file, shape, valueBytes)));
    }

    private static List<Integer> shape(Path file, String tuple) {
        try {
            return Arrays.stream(tuple.split(","))
                    .map(String::strip)
                    .filter(part -> !part.isEmpty())
                    .map(Integer::valueOf)
                    .toList();
        } catch (NumberFormatException failure) {
            throw new InputException("cannot read " + file + ": not a shape: (" + tuple + ")", failure);
        }
    }

    /** The number of values, checked against the file's length before memory is taken for them. */
    private static int count(Path file, List<Integer> shape, long valueBytes) {
        // In double: a product of hostile lengths must not wrap around.
        double count = shape.stream().mapToDouble(Integer::doubleValue).reduce(1, (a, b) -> a * b);
        if (count * Float.BYTES != valueBytes || valueBytes > Integer.MAX_VALUE) {
            throw new InputException("cannot read " + file + ": the shape " + shape + " takes "
                    + (long) (count * Float.BYTES) + " bytes (2 GiB at most), the file has " + valueBytes);
        }
        return (int) count;
    }

    private static float[] values(InputStream stream, int count) throws IOException {
        float[] values = new float[count];
        ByteBuffer.wrap(stream.readNBytes(count * Float.BYTES))
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(values);
        return values;
    }
}
